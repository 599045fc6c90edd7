#include "app/window/pending_import.hpp"

#include <algorithm>
#include <filesystem>

#include "core/survey/build_global_inventory.hpp"
#include "io/crs.hpp"
#include "io/inventory_date.hpp"

namespace stemwise {
namespace {

constexpr std::size_t rows_shown = 40;

InventoryPreview read_ready(const std::string& path, const ReadOptions& options, const Progress& progress) {
  InventoryPreview preview = preview_inventory(path, options);
  progress.check();
  if (preview.inventory) *preview.inventory = with_global_stems(std::move(*preview.inventory), {}, progress.stage(0.3, 1.0));
  return preview;
}

/// A word of the command line in quotes where it needs them.
std::string quoted(const std::string& text) { return text.find_first_of(" \t'\"();&|<>*?$") == std::string::npos ? text : "\"" + text + "\""; }

/// What `stemwise align` and `convert` are told for the same reading. The system of plain x and y has no option there.
std::string command_line_of(const ui::ImportSettings& s) {
  std::string text;
  const auto add = [&](const std::string& option, const std::string& value) { text += (text.empty() ? "" : " ") + option + " " + quoted(value); };
  for (const auto& [kind, header] : s.columns) {
    if (!header.empty()) add("--map", kind + "=" + header);
  }
  for (const auto& [kind, unit] : s.units) add("--unit", kind + "=" + unit);
  for (const auto& [code, status] : s.status_codes) add("--status", code + "=" + to_string(status));
  if (!s.sheet.empty()) add("--sheet", s.sheet);
  if (!s.plot.empty()) add("--plot-column", s.plot_column), add("--plot", s.plot);
  if (s.date) add("--date", to_string(*s.date));
  return text;
}

}  // namespace

ReadOptions read_options(const ui::ImportSettings& s) {
  ReadOptions options;
  options.columns = s.columns;
  options.units = s.units;
  options.status_codes = s.status_codes;
  options.sheet = s.sheet;
  options.plot_column = s.plot_column;
  options.plot = s.plot;
  options.date = s.date;
  options.epsg = s.epsg;
  return options;
}

PendingImport read_pending(const std::string& path, const ImportMemory& memory, const Progress& progress) {
  PendingImport pending;
  pending.preview = read_ready(path, {}, progress);
  const auto known = memory.find(pending.preview.header);
  if (!known) return pending;
  InventoryPreview again = read_ready(path, *known, progress);
  if (!again.inventory) return pending;
  pending.preview = std::move(again);
  pending.remembered = true;
  pending.settings.columns = known->columns;
  pending.settings.units = known->units;
  pending.settings.status_codes = known->status_codes;
  pending.settings.epsg = known->epsg;
  return pending;
}

InventoryPreview read_again(const std::string& path, const ui::ImportSettings& settings, const Progress& progress) {
  return read_ready(path, read_options(settings), progress);
}

bool is_in_doubt(const PendingImport& pending) {
  if (!pending.preview.inventory) return true;
  const Issues& issues = pending.preview.inventory.issues;
  return std::any_of(issues.begin(), issues.end(), [](const Issue& i) { return i.severity != Severity::note; });
}

ui::ImportFile import_view(const PendingImport& pending) {
  const InventoryPreview& p = pending.preview;
  ui::ImportFile file;
  file.path = p.path;
  file.file_name = std::filesystem::path(p.path).filename().string();
  file.format = p.format;
  file.settings = pending.settings;
  file.reading = pending.reading;
  file.remembered = pending.remembered;
  file.name = inventory_name(p.path);
  file.row_count = p.row_count;
  file.sheets = p.sheets;
  file.sheet = p.sheet;
  file.header = p.header;
  file.plot_columns = p.plot_columns;
  file.plot_column = p.plot_column;
  file.plots = p.plots;
  for (const ColumnPreview& c : p.columns) file.columns.push_back({c.kind, c.header, c.unit, c.how, c.guessed});
  for (const StatusCodePreview& c : p.status_codes) file.codes.push_back({c.code, c.rows, c.meaning});
  file.row_numbers = p.row_numbers;
  file.rows = p.rows;
  file.issues = p.inventory.issues;
  for (Issue& issue : file.issues) {
    if (issue.help.find("--") != std::string::npos) issue.help.clear();  // the dialog has a control for it
  }
  std::stable_sort(file.issues.begin(), file.issues.end(), [](const Issue& a, const Issue& b) { return a.severity > b.severity; });
  file.command_line = command_line_of(pending.settings);
  if (!p.inventory) return file;
  const Inventory& inventory = *p.inventory;
  file.usable = true;
  file.date = inventory.date;
  file.epsg = inventory.source.epsg;
  if (file.epsg) file.system = crs_name(*file.epsg);
  file.stem_count = static_cast<std::int64_t>(inventory.stems.size());
  file.notes = inventory.source.notes;
  file.stems.assign(inventory.stems.begin(), inventory.stems.begin() + static_cast<std::ptrdiff_t>(std::min(rows_shown, inventory.stems.size())));
  return file;
}

}  // namespace stemwise
