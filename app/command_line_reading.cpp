#include <CLI/CLI.hpp>
#include <memory>

#include "app/command_registry.hpp"
#include "app/commands/align.hpp"
#include "app/commands/convert.hpp"
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
  add("--status", read.status, "What a status code means: K=dead (alive, dead, removed, missing, unknown)");
}

void add_info(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "info", "What is in a file or folder: format, columns, units, count, date, extent, every problem");
  const auto options = std::make_shared<InfoOptions>();
  command.add_option("PATH", options->paths, "Inventories: files or frame folders")->required();
  add_read_options(command, options->read);
  command.callback([options, &chosen] { chosen.run = [options](Session& session) { return run_info(*options, session); }; });
}

void add_convert(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "convert", "One inventory format to another: .csv, .tsv, or a folder of frames");
  const auto options = std::make_shared<ConvertOptions>();
  command.add_option("IN", options->input, "Inventory: a file or a frame folder")->required();
  command.add_option("-o,--output", options->output, "What to write; the suffix says the format")->required();
  add_read_options(command, options->read);
  command.callback([options, &chosen] { chosen.run = [options](Session& session) { return run_convert(*options, session); }; });
}

void add_align(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  CLI::App& command = add_command(root, common, "align", "Align inventories of one forest, match their stems, write a project");
  const auto options = std::make_shared<AlignOptions>();
  command.add_option("INVENTORY", options->inventories, "Two or more inventories: files or frame folders; a project first: the others are added to it, and its tree ids stay")->required()->expected(2, -1);
  command.add_option("-o,--output", options->output, "The project to write, PROJECT.gpkg")->required();
  command.add_option("--reference", options->reference, "Name of the inventory whose frame is kept (default: the one with the most trees)");
  command.add_option("--hint", options->hint, "JSON file with pairs of the same trees, or a rough pose");
  command.add_option("--crs", options->crs, "EPSG:N of every inventory's coordinates: a prior of 10 m and 20 degrees where stems alone prove nothing, and the project's georeference");
  command.add_flag("--accept-probable", options->accept_probable, "Apply poses that are only probable");
  add_read_options(command, options->read);
  command.callback([options, &chosen] { chosen.run = [options](Session& session) { return run_align(*options, session); }; });
}

}  // namespace

void add_reading_commands(CLI::App& root, CommonOptions& common, ChosenCommand& chosen) {
  add_info(root, common, chosen);
  add_convert(root, common, chosen);
  add_align(root, common, chosen);
}

}  // namespace stemwise
