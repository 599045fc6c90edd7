#pragma once
#include <functional>
#include <string>
#include <vector>

#include "io/report/document.hpp"
#include "io/report/pdf_canvas.hpp"

namespace stemwise {

/// Some columns of a table that fit beside each other, at one size of type. The first column stands in every part.
struct TablePart {
  std::vector<std::size_t> columns;
  std::vector<double> widths_pt;
  double size_pt = 8.0;
};

/// The largest type at which all columns fit into `width_pt`; below 6.5 pt the columns are dealt out to several parts.
std::vector<TablePart> fit_table(PdfCanvas& canvas, const ReportTable& table, double width_pt);

double table_head_height(PdfCanvas& canvas, const ReportTable& table, const TablePart& part);
double table_row_height(PdfCanvas& canvas, const ReportTable& table, const TablePart& part, std::size_t row);
void draw_table_head(PdfCanvas& canvas, const ReportTable& table, const TablePart& part, double x, double y);
void draw_table_row(PdfCanvas& canvas, const ReportTable& table, const TablePart& part, std::size_t row, double x, double y);

}  // namespace stemwise
