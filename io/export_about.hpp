#pragma once
#include <string>
#include <vector>

#include "core/project/project_state.hpp"
#include "io/earth_frame.hpp"
#include "io/layer.hpp"

namespace stemwise {

/// Key and value of everything that an export should say about itself: software, CRS, units, settings, seed, alignment.
Layer about_layer(const ProjectState& state, const EarthFrame& frame, const std::string& software);
/// What every column of the layers means.
Layer data_dictionary(const std::vector<Layer>& layers);
/// Both as text for the file beside an export of one layer. `short_names`: with the ten letters of a Shapefile's columns.
std::string about_text(const ProjectState& state, const EarthFrame& frame, const std::string& software, const Layer& layer, bool short_names);

}  // namespace stemwise
