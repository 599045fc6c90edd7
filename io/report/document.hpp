#pragma once
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/survey/report_model.hpp"
#include "io/report/drawing.hpp"

namespace stemwise {

// The report as a person reads it, before it is HTML, PDF or CSV: sections of paragraphs, key figures, tables and charts.
// Numbers in cells are plain ("-1.2"); the writers for print give them a true minus sign.

struct ReportColumn {
  std::string name;     ///< with its unit: "DBH cm"
  bool is_number = true;
};

struct ReportTable {
  std::string title;
  std::string note;                 ///< below it: conventions, what was counted
  std::vector<ReportColumn> columns;
  std::vector<std::vector<std::string>> rows;
  std::size_t printed_rows = 0;     ///< 0: all; else print has the first so many and says so (CSV always has all)
};

struct ReportParagraph {
  std::string text;
  bool is_warning = false;
};

struct ReportFigure {
  std::string value;   ///< "4,688"
  std::string label;   ///< "trees"
  std::string detail;  ///< "in 3 surveys"
};
using ReportFigures = std::vector<ReportFigure>;

struct ReportChart {
  Drawing drawing;
  std::string caption;
};

using ReportBlock = std::variant<ReportParagraph, ReportFigures, ReportTable, ReportChart>;

struct ReportSection {
  std::string title;
  std::vector<ReportBlock> blocks;
};

/// The first page.
struct ReportCover {
  ReportFigures figures;
  std::optional<ReportChart> map;
  std::vector<std::pair<std::string, std::string>> facts;  ///< label and text
};

struct ReportDocument {
  std::string title;
  std::string subtitle;
  ReportCover cover;
  std::vector<ReportSection> sections;
  std::string footer;  ///< software and version
};

ReportDocument make_report_document(const ReportModel& model, const std::string& software);

}  // namespace stemwise
