#include "ui/panels/table_view.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace stemwise::ui {
namespace {

/// A small triangle that says which way a column sorts.
void draw_sort_mark(Widgets& w, const Rect& at, bool ascending) {
  const float x = at.center_x(), y = at.center_y(), r = w.px(3), tip = ascending ? -r : r;
  ImGui::GetWindowDrawList()->AddTriangleFilled({x, y + tip}, {x + r, y - 0.6f * tip}, {x - r, y - 0.6f * tip}, w.tokens().secondary.packed());
}

void draw_head(Widgets& w, const TableView& table) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, w.px(26));
  const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    ImGui::TableSetColumnIndex(static_cast<int>(c));
    w.push_font(TextRole::caption);
    ImGui::PushStyleColor(ImGuiCol_Text, 0);  // the table's own arrow and words give way to ours, which use the whole width
    ImGui::PushStyleColor(ImGuiCol_HeaderHovered, w.tokens().canvas.packed());
    const Rect head = w.next_rect(w.available_width(), w.line_height(TextRole::caption));
    ImGui::TableHeader(("##" + table.columns[c].name).c_str());
    ImGui::PopStyleColor(2);
    w.pop_font();
    const Column& column = table.columns[c];
    const bool sorted = (ImGui::TableGetColumnFlags(static_cast<int>(c)) & ImGuiTableColumnFlags_IsSorted) != 0;
    const float mark = sorted ? w.px(12) : 0.0f;
    w.text_in({head.x, head.y, head.width - mark, head.height}, column.name, TextRole::caption, Tone::secondary, column.number ? Align::right : Align::left);
    if (sorted && specs != nullptr && specs->SpecsCount > 0) {
      const float at = column.number ? head.right() - w.px(8) : head.x + std::min(w.text_width(column.name, TextRole::caption) + w.px(4), head.width - w.px(8));
      draw_sort_mark(w, {at, head.y, w.px(8), head.height}, specs->Specs[0].SortDirection != ImGuiSortDirection_Descending);
    }
    w.record_last(table.path + "/head/" + table.columns[c].name, table.columns[c].name);
  }
}

void apply_sorting(const TableView& table) {
  ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (specs == nullptr || !specs->SpecsDirty || !table.sorted) return;
  if (specs->SpecsCount > 0) {
    table.sorted(static_cast<std::size_t>(specs->Specs[0].ColumnIndex), specs->Specs[0].SortDirection != ImGuiSortDirection_Descending);
  }
  specs->SpecsDirty = false;
}

/// A row that was clicked does not move away under the mouse.
bool is_in_sight(std::size_t row, float row_height) {
  const float top = row_height * static_cast<float>(row) - ImGui::GetScrollY();
  return top >= 0.0f && top + 2.0f * row_height <= ImGui::GetWindowHeight();  // the head takes one row of the height
}

/// Tab goes to one row only, and on to the next control: through the rows lead the arrow keys, which select.
std::size_t row_of_tab(const TableView& table) {
  for (std::size_t row = 0; table.selected && row < table.rows; ++row)
    if (table.selected(row)) return row;
  return 0;
}

void draw_row(Widgets& w, const TableView& table, std::size_t row, std::size_t by_tab) {
  const float height = w.px(28);
  ImGui::TableNextRow(ImGuiTableRowFlags_None, height);
  ImGui::TableSetColumnIndex(0);
  const bool selected = table.selected && table.selected(row);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(static_cast<int>(row));
  // The row's own selectable reaches over all columns; the cells are drawn over it.
  const float pad = ImGui::GetStyle().CellPadding.y;
  const bool pressed = ImGui::Selectable("##row", selected, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap,
                                         {0, height - 2 * pad});
  const bool reached = GImGui->NavJustMovedToId != 0 && GImGui->NavJustMovedToId == ImGui::GetItemID();  // by the arrow keys
  const std::string path = table.path + "/row/" + std::to_string(row);
  w.record_last(path, table.cell(row, 0).text, true, false, row == by_tab);
  ImGui::PopID();
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    ImGui::TableSetColumnIndex(static_cast<int>(c));
    const TableCell cell = table.cell(row, c);
    const Rect rect{ImGui::GetCursorScreenPos().x, at.y, ImGui::GetContentRegionAvail().x, height - 2 * pad};
    w.text_in(rect, cell.text, TextRole::table, cell.tone, table.columns[c].number ? Align::right : Align::left);
  }
  if ((pressed || reached) && table.clicked) table.clicked(row);
}

}  // namespace

void draw_filter(Widgets& w, const std::string& path, std::string& text, const std::string& hint, const std::string& beside) {
  const Rect line = w.next_rect(w.available_width(), w.px(28));
  const float width = std::min(w.px(280), line.width);
  w.input(path, text, {.hint = hint, .width = width});
  const float height = ImGui::GetItemRectSize().y;
  w.text_in({line.x + width + w.px(16), line.y, line.width - width - w.px(16), height}, beside, TextRole::table, Tone::secondary);
}

void draw_table(Widgets& w, const TableView& table) {
  if (table.rows == 0) {
    w.gap(8);
    w.text(table.empty_text, TextRole::body, Tone::secondary);
    return;
  }
  ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX;
  if (table.sorted) flags |= ImGuiTableFlags_Sortable;
  const bool wide = table.least_width > w.available_width();
  if (wide) flags |= ImGuiTableFlags_ScrollX;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {w.px(8), w.px(3)});
  if (ImGui::BeginTable(table.path.c_str(), static_cast<int>(table.columns.size()), flags, {0, 0}, wide ? table.least_width : 0.0f)) {
    ImGui::TableSetupScrollFreeze(0, 1);
    for (const Column& c : table.columns) {
      const ImGuiTableColumnFlags first = c.sorts_first ? ImGuiTableColumnFlags_DefaultSort : 0;
      ImGui::TableSetupColumn(c.name.c_str(), ImGuiTableColumnFlags_WidthStretch | first, c.weight);
    }
    draw_head(w, table);
    apply_sorting(table);
    const float row_height = w.px(28);
    const std::size_t by_tab = row_of_tab(table);
    if (table.scroll_to < table.rows && !is_in_sight(table.scroll_to, row_height)) ImGui::SetScrollY(std::max(0.0f, row_height * (static_cast<float>(table.scroll_to) - 2.0f)));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(table.rows), row_height);
    while (clipper.Step()) {
      for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) draw_row(w, table, static_cast<std::size_t>(row), by_tab);
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

}  // namespace stemwise::ui
