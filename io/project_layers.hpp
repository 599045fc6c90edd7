#pragma once
#include <vector>

#include "core/survey/tables.hpp"
#include "io/earth_frame.hpp"
#include "io/layer.hpp"

namespace stemwise {

/// `forestgeo` is made only when it is asked for by name.
enum class LayerKind { trees, observations, matches, links, inventories, coverage, forestgeo };
inline constexpr std::size_t layer_kind_count = 6;  ///< those of a project and of "every layer"
const char* to_string(LayerKind kind);
std::optional<LayerKind> layer_kind_from(std::string_view word);

/// One layer with the columns of cli.md ("Export columns"), placed by `frame`. `tables` are those of `state`.
Layer project_layer(LayerKind kind, const ProjectState& state, const Tables& tables, const EarthFrame& frame);
/// All of them in the order of cli.md.
std::vector<Layer> project_layers(const ProjectState& state, const Tables& tables, const EarthFrame& frame);

}  // namespace stemwise
