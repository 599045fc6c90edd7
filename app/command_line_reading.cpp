#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_registry.hpp"
#include "app/commands/info.hpp"

namespace stemwise {
namespace {

void add_read_options(CLI::App& command, ReadOverrides& read) {
  const auto add = [&command](const char* name, std::vector<std::string>& into, const char* what) {
    command.add_option(name, into, what)->allow_extra_args(false)->group("Reading (a value may begin with NAME: for one inventory)");
  };
  add("--map", read.map, "Which column is what: x=Easting");
  add("--unit", read.unit, "Unit of a column: dbh=mm, x=ft");
  add("--sheet", read.sheet, "Sheet of a workbook");
  add("--plot-column", read.plot_column, "Column that names the plot");
  add("--plot", read.plot, "Only the rows of this plot");
  add("--date", read.date, "Date of the survey: 2023-05-04");
}

void add_info(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "info", "What is in a file or folder: format, columns, units, count, date, extent, every problem");
  const auto options = std::make_shared<InfoOptions>();
  command.add_option("PATH", options->paths, "Inventories: files or frame folders")->required();
  add_read_options(command, options->read);
  command.callback([options, &chosen] { chosen.run = [options](Session& session) { return run_info(*options, session); }; });
}

}  // namespace

void add_reading_commands(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) { add_info(root, common, chosen); }

}  // namespace stemwise
