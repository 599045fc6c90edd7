#include <algorithm>

#include "io/report/write_report.hpp"

namespace stemwise {
namespace {

std::string quoted(const std::string& cell, char delimiter) {
  const std::string special = std::string("\"\r\n") + delimiter;
  if (cell.find_first_of(special) == std::string::npos) return cell;
  std::string out = "\"";
  for (const char c : cell) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string line_of(const std::vector<std::string>& cells, char delimiter) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i == 0 ? "" : std::string(1, delimiter)) + quoted(cells[i], delimiter);
  return line + "\r\n";
}

std::string table_csv(const ReportTable& table, char delimiter, bool decimal_comma) {
  std::string csv = line_of({table.title}, delimiter);
  std::vector<std::string> head;
  for (const ReportColumn& column : table.columns) head.push_back(column.name);
  csv += line_of(head, delimiter);
  for (std::vector<std::string> row : table.rows) {
    for (std::size_t c = 0; decimal_comma && c < row.size(); ++c) {
      if (table.columns[c].is_number) std::replace(row[c].begin(), row[c].end(), '.', ',');
    }
    csv += line_of(row, delimiter);
  }
  return csv + (table.note.empty() ? "" : line_of({"Note: " + table.note}, delimiter));
}

}  // namespace

std::string report_csv(const ReportDocument& document, char delimiter, bool decimal_comma) {
  std::string csv = "\xEF\xBB\xBF" + line_of({document.title}, delimiter) + line_of({document.subtitle}, delimiter) + line_of({document.footer}, delimiter);
  for (const ReportSection& section : document.sections) {
    for (const ReportBlock& block : section.blocks) {
      if (const auto* table = std::get_if<ReportTable>(&block)) csv += "\r\n" + table_csv(*table, delimiter, decimal_comma);
    }
  }
  return csv;
}

}  // namespace stemwise
