#include "io/report/pdf_table.hpp"

#include <algorithm>
#include <numeric>

#include "io/report/palette.hpp"
#include "io/report/print_text.hpp"

namespace stemwise {
namespace {

constexpr double gap_pt = 8.0;      ///< between columns
constexpr double padding_pt = 2.6;  ///< above and below a row's text
constexpr double longest_text_pt = 150.0;

TextStyle head_style(double size_pt) { return {size_pt, palette::secondary, false}; }
TextStyle cell_style(double size_pt) { return {size_pt, palette::text, false}; }

std::string cell_text(const ReportTable& table, std::size_t row, std::size_t column) {
  const std::string& cell = table.rows[row][column];
  return table.columns[column].is_number ? print_number(cell) : cell;
}

std::size_t printed_rows(const ReportTable& table) {
  return table.printed_rows == 0 ? table.rows.size() : std::min(table.printed_rows, table.rows.size());
}

/// A column of text right behind one of numbers stands off, so that the two do not read as one.
double gap_before(const ReportTable& table, std::size_t column) { return column > 0 && table.columns[column - 1].is_number && !table.columns[column].is_number ? 6.0 : 0.0; }

/// Numbers never wrap; text wraps beyond `longest_text_pt`; heads wrap between words.
double column_width(PdfCanvas& canvas, const ReportTable& table, std::size_t column, double size_pt) {
  double width = canvas.word_width(table.columns[column].name, head_style(size_pt));
  for (std::size_t row = 0; row < printed_rows(table); ++row) {
    const std::string text = cell_text(table, row, column);
    const double natural = canvas.text_width(text, cell_style(size_pt));
    width = std::max(width, table.columns[column].is_number ? natural : std::min(natural, longest_text_pt));
  }
  return width + gap_before(table, column) + 0.5;
}

double total_width(const TablePart& part) {
  return std::accumulate(part.widths_pt.begin(), part.widths_pt.end(), 0.0) + gap_pt * static_cast<double>(part.widths_pt.size() - 1);
}

TablePart part_at(PdfCanvas& canvas, const ReportTable& table, double size_pt) {
  TablePart part;
  part.size_pt = size_pt;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    part.columns.push_back(c);
    part.widths_pt.push_back(column_width(canvas, table, c, size_pt));
  }
  return part;
}

/// What is left of the page's width goes to the gaps, so that tables stand in one measure.
void spread(TablePart& part, double width_pt) {
  const double each = (width_pt - total_width(part)) / static_cast<double>(part.widths_pt.size());
  for (double& width : part.widths_pt) width += std::min(each, 40.0);
}

/// Columns of text that were cut at `longest_text_pt` get what room is left, before it goes to the gaps.
void widen_text(PdfCanvas& canvas, const ReportTable& table, TablePart& part, double width_pt) {
  for (std::size_t i = 0; i < part.columns.size(); ++i) {
    if (table.columns[part.columns[i]].is_number) continue;
    double natural = 0.0;
    for (std::size_t row = 0; row < printed_rows(table); ++row) natural = std::max(natural, canvas.text_width(cell_text(table, row, part.columns[i]), cell_style(part.size_pt)));
    const double wanted = natural + gap_before(table, part.columns[i]) + 0.5 - part.widths_pt[i];
    if (wanted > 0.0) part.widths_pt[i] += std::min(wanted, width_pt - total_width(part));
  }
}

std::vector<TablePart> deal_out(const TablePart& whole, double width_pt) {
  std::vector<TablePart> parts;
  for (std::size_t c = 1; c < whole.columns.size(); ++c) {
    const double added = whole.widths_pt[c] + gap_pt;
    if (parts.empty() || total_width(parts.back()) + added > width_pt) parts.push_back({{0}, {whole.widths_pt[0]}, whole.size_pt});
    parts.back().columns.push_back(c);
    parts.back().widths_pt.push_back(whole.widths_pt[c]);
  }
  return parts;
}

template <class TextOf>
double tallest(PdfCanvas& canvas, const ReportTable& table, const TablePart& part, const TextStyle& style, TextOf text_of) {
  double height = 0.0;
  for (std::size_t i = 0; i < part.columns.size(); ++i) {
    height = std::max(height, canvas.text_height(text_of(part.columns[i]), style, part.widths_pt[i] - (i > 0 ? gap_before(table, part.columns[i]) : 0.0)));
  }
  return height;
}

TextAnchor anchor_of(const ReportColumn& column) { return column.is_number ? TextAnchor::end : TextAnchor::start; }

}  // namespace

std::vector<TablePart> fit_table(PdfCanvas& canvas, const ReportTable& table, double width_pt) {
  TablePart part;
  for (const double size_pt : {8.5, 8.0, 7.5, 7.0, 6.5}) {
    part = part_at(canvas, table, size_pt);
    if (total_width(part) > width_pt) continue;
    widen_text(canvas, table, part, width_pt);
    spread(part, width_pt);
    return {part};
  }
  std::vector<TablePart> parts = deal_out(part_at(canvas, table, 7.5), width_pt);
  for (TablePart& one : parts) spread(one, width_pt);
  return parts;
}

double table_head_height(PdfCanvas& canvas, const ReportTable& table, const TablePart& part) {
  return tallest(canvas, table, part, head_style(part.size_pt), [&](std::size_t c) { return print_prose(table.columns[c].name); }) + 2.0 * padding_pt;
}

double table_row_height(PdfCanvas& canvas, const ReportTable& table, const TablePart& part, std::size_t row) {
  return tallest(canvas, table, part, cell_style(part.size_pt), [&](std::size_t c) { return cell_text(table, row, c); }) + 2.0 * padding_pt;
}

void draw_table_head(PdfCanvas& canvas, const ReportTable& table, const TablePart& part, double x, double y) {
  const double height = table_head_height(canvas, table, part);
  double left = x;
  for (std::size_t i = 0; i < part.columns.size(); ++i) {
    const ReportColumn& column = table.columns[part.columns[i]];
    const std::string name = print_prose(column.name);
    const double indent = i > 0 ? gap_before(table, part.columns[i]) : 0.0;
    const double own = canvas.text_height(name, head_style(part.size_pt), part.widths_pt[i] - indent);
    canvas.text(left + indent, y + height - padding_pt - own, part.widths_pt[i] - indent, name, head_style(part.size_pt), anchor_of(column));
    left += part.widths_pt[i] + gap_pt;
  }
  canvas.rule(x, y + height, left - gap_pt - x, palette::secondary, 0.7);
}

void draw_table_row(PdfCanvas& canvas, const ReportTable& table, const TablePart& part, std::size_t row, double x, double y) {
  double left = x;
  for (std::size_t i = 0; i < part.columns.size(); ++i) {
    const std::size_t column = part.columns[i];
    const double indent = i > 0 ? gap_before(table, column) : 0.0;
    canvas.text(left + indent, y + padding_pt, part.widths_pt[i] - indent, cell_text(table, row, column), cell_style(part.size_pt), anchor_of(table.columns[column]));
    left += part.widths_pt[i] + gap_pt;
  }
  canvas.rule(x, y + table_row_height(canvas, table, part, row), left - gap_pt - x, palette::grid, 0.5);
}

}  // namespace stemwise
