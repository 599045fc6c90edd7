#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_registry.hpp"
#include "app/window/run_window.hpp"

namespace stemwise {

void add_window_command(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& gui = add_command(root, common, "gui", "The desktop window, with a project or inventories (the same as: stemwise [FILE...])");
  const auto options = std::make_shared<WindowOptions>();
  gui.add_option("FILE", options->paths, "A project, or inventories (files and frame folders)");
  // For scripts and tests; not part of the contract.
  gui.add_option("--ui-json", options->ui_json, "Write every widget's place to this file whenever it changes")->group("");
  gui.add_option("--script", options->script, "Drive the window without a display by the lines of this file")->group("");
  gui.add_option("--width", options->width)->group("");
  gui.add_option("--height", options->height)->group("");
  gui.callback([options, &chosen] { chosen.run = [options](Session& session) { return static_cast<ExitCode>(run_window(*options, session.cancel)); }; });
}

}  // namespace stemwise
