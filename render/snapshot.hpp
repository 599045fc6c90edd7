#pragma once
#include <string>

#include "core/project/project_state.hpp"
#include "core/survey/tables.hpp"
#include "render/picture.hpp"
#include "render/view_options.hpp"

namespace stemwise::render {

struct SnapshotSettings {
  PixelSize size{1600, 1000};
  double scale = 1.0;  ///< of text and lines; 2 for print
};

/// The whole project in one picture, with title, legend, scale bar and north arrow; no display needed. An issue where no
/// picture can be drawn. An empty `options.title` becomes the project's title or the names of its surveys.
Result<Image> take_snapshot(const ProjectState& state, const Tables& tables, ViewOptions options, const SnapshotSettings& settings);
Result<Done> write_snapshot(const ProjectState& state, const Tables& tables, const ViewOptions& options, const SnapshotSettings& settings,
                            const std::string& path);

}  // namespace stemwise::render
