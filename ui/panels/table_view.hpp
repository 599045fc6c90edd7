#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

struct Column {
  std::string name;
  float weight = 1.0f;
  bool number = false;  ///< right-aligned
  bool sorts_first = false;
};

/// A table in our look: a head that sorts, rows of 28 px, only the visible ones drawn. `cell` draws one cell by writing
/// its text and tone; `row` is the place in the order shown.
struct TableCell {
  std::string text;
  Tone tone = Tone::text;
};

struct TableView {
  std::string path;
  std::vector<Column> columns;
  std::size_t rows = 0;
  std::function<TableCell(std::size_t row, std::size_t column)> cell;
  std::function<bool(std::size_t row)> selected;
  std::function<void(std::size_t row)> clicked;
  std::function<void(std::size_t column, bool ascending)> sorted;  ///< empty: the head does not sort
  std::size_t scroll_to = static_cast<std::size_t>(-1);            ///< a row to bring into view
  float least_width = 0.0f;                                        ///< px; wider than the room: scrolls sideways
  std::string empty_text = "Nothing here";
};

/// The line above a table: a field that filters it, and a few words beside it.
void draw_filter(Widgets& w, const std::string& path, std::string& text, const std::string& hint, const std::string& beside = {});
void draw_table(Widgets& w, const TableView& table);

}  // namespace stemwise::ui
