#include "app/window/previews.hpp"
#include "app/window/project_io.hpp"
#include "core/survey/field_check.hpp"
#include "io/crs.hpp"
#include "io/project_layers.hpp"
#include "io/report/document.hpp"
#include "io/report/print_text.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

std::string text_of(const LayerValue& value, const LayerColumn& column) {
  if (const auto* number = std::get_if<double>(&value)) return ui::fixed(*number, column.decimals);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return "";
}

/// "2 tables, 1 chart".
std::string content_of(const ReportSection& section) {
  int tables = 0, charts = 0, rows = 0;
  for (const ReportBlock& block : section.blocks) {
    if (const auto* table = std::get_if<ReportTable>(&block)) {
      ++tables;
      rows += static_cast<int>(table->rows.size());
    }
    charts += std::holds_alternative<ReportChart>(block) ? 1 : 0;
  }
  std::string words;
  if (tables > 0) words = ui::plural(tables, "table", "tables") + " (" + ui::plural(rows, "row", "rows") + ")";
  if (charts > 0) words += (words.empty() ? "" : ", ") + ui::plural(charts, "chart", "charts");
  return words.empty() ? "text" : words;
}

}  // namespace

ui::ExportPreview preview_export(const ui::ExportForm& form, const ProjectState& state, const Tables& tables) {
  ui::ExportPreview preview;
  preview.form = form;
  const auto frame = EarthFrame::of(state.georeference, form.epsg == 0 ? std::nullopt : std::optional(form.epsg));
  const auto kind = layer_kind_from(form.layer);
  preview.issues = frame.issues;
  if (!frame || !kind) return preview;
  const Layer layer = project_layer(*kind, state, tables, *frame);
  preview.rows = static_cast<std::int64_t>(layer.features.size());
  preview.system = frame->epsg() ? crs_name(*frame->epsg()) + ", EPSG:" + std::to_string(*frame->epsg()) : "local coordinates, metres";
  for (std::size_t c = 0; c < layer.columns.size() && !layer.features.empty(); ++c) {
    preview.first.emplace_back(layer.columns[c].name, text_of(layer.features.front().values[c], layer.columns[c]));
  }
  return preview;
}

ui::ReportPreview preview_report(double area_ha, const ProjectState& state, const Tables& tables) {
  ui::ReportPreview preview;
  preview.area_ha = area_ha;
  const ReportDocument document = growth_report(state, tables, area_ha);
  for (const ReportFigure& figure : document.cover.figures) preview.figures.push_back({figure.label, print_number(figure.value), print_prose(figure.detail)});
  for (const ReportSection& section : document.sections) preview.sections.emplace_back(section.title, content_of(section));
  preview.field_check_trees = static_cast<int>(make_field_check(state, tables, tables.queue.size()).rows.size());
  return preview;
}

RecordedPages preview_pages(const ui::PageForm& form, const ProjectState& state, const Tables& tables) {
  if (form.sheet == ui::PrintedSheet::report) return report_pages(growth_report(state, tables, form.area_ha));
  return report_pages(field_check_sheet(state, tables, form.most_trees, true));
}

}  // namespace stemwise
