#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "io/report/document.hpp"

namespace stemwise {

/// One self-contained HTML page: styles inside, charts as inline SVG, nothing fetched from anywhere.
std::string report_html(const ReportDocument& document);
/// All tables of the report, one below the other, each under its title; RFC 4180 with a UTF-8 byte order mark.
std::string report_csv(const ReportDocument& document, char delimiter = ',', bool decimal_comma = false);
/// A4 pages with page numbers and repeated table heads; fonts embedded. The bytes of the PDF; nothing when it cannot be drawn.
std::optional<std::string> report_pdf(const ReportDocument& document);

/// A workbook: a first sheet with the key figures and paragraphs, and one sheet per table, numbers as numbers.
Result<Done> write_report_xlsx(const std::string& path, const ReportDocument& document);

/// What a report can be written as: ".pdf", ".html", ...
const std::vector<std::string>& report_suffixes();

/// By suffix: .html, .csv, .xlsx or .pdf. A whole file or none. An issue for another suffix or a path that cannot be written.
Result<Done> write_report(const std::string& path, const ReportDocument& document);

}  // namespace stemwise
