#include <filesystem>

#include "app/check_output.hpp"
#include "app/commands/open_project.hpp"
#include "app/commands/project_commands.hpp"
#include "app/result_json.hpp"
#include "core/survey/tables.hpp"
#include "render/snapshot.hpp"

namespace stemwise {
namespace {

std::optional<render::ViewOptions> view_of(const SnapshotOptions& options, Console& console) {
  render::ViewOptions view;
  if (options.view != "map" && options.view != "3d") {
    console.error("--view " + options.view + ": expected map or 3d");
    return std::nullopt;
  }
  view.kind = options.view == "map" ? render::ViewKind::map : render::ViewKind::space;
  const auto color_by = render::color_by_from(options.color_by);
  if (!color_by) {
    std::string words;
    for (const render::ColorBy by : render::all_color_bys) words += (words.empty() ? "" : ", ") + std::string(render::to_string(by));
    console.error("--color-by " + options.color_by + ": expected one of " + words);
    return std::nullopt;
  }
  view.color_by = *color_by;
  view.theme = options.dark ? render::Theme::dark : render::Theme::light;
  return view;
}

}  // namespace

ExitCode run_snapshot(const SnapshotOptions& options, Session& session) {
  const std::optional<render::ViewOptions> view = view_of(options, session.console);
  if (!view) return ExitCode::usage;
  if (options.width_px < 64 || options.height_px < 64 || options.width_px > 16384 || options.height_px > 16384) {
    session.console.error("--size: between 64x64 and 16384x16384");
    return ExitCode::usage;
  }
  if (!options.output.ends_with(".png") && !options.output.ends_with(".PNG")) {
    session.console.error("-o " + options.output + ": a snapshot is a PNG picture; give it a name that ends in .png");
    return ExitCode::usage;
  }
  if (const ExitCode code = check_output(options.output, OutputKind::other, {options.project}, session.console); code != ExitCode::done) return code;
  const std::optional<OpenedProject> opened = open_project(options.project, session);
  if (!opened) return ExitCode::unusable_input;
  if (const ExitCode code = check_no_source(options.output, opened->project.state(), session.console); code != ExitCode::done) return code;
  const Tables tables = derive_tables(opened->project.state());
  render::SnapshotSettings settings;
  settings.size = {options.width_px, options.height_px};
  const Result<Done> written = render::write_snapshot(opened->project.state(), tables, *view, settings, options.output);
  session.console.issues(written.issues);
  if (!written) return ExitCode::failed;
  session.console.say(options.output + ": written");
  return session.write_json(result_json({{"output", options.output}}));
}

}  // namespace stemwise
