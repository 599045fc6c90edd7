#include "io/report/write_report.hpp"

#include <algorithm>
#include <filesystem>

#include "io/replace_file.hpp"

namespace stemwise {
namespace fs = std::filesystem;

const std::vector<std::string>& report_suffixes() {
  static const std::vector<std::string> suffixes = {".pdf", ".html", ".htm", ".xlsx", ".csv"};
  return suffixes;
}

Result<Done> write_report(const std::string& path, const ReportDocument& document) {
  std::string suffix = fs::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".html" || suffix == ".htm") {
    return write_text_file(path, report_html(document));
  }
  if (suffix == ".csv") {
    return write_text_file(path, report_csv(document));
  }
  if (suffix == ".xlsx") return write_report_xlsx(path, document);
  if (suffix == ".pdf") {
    if (const auto bytes = report_pdf(document)) return write_text_file(path, *bytes);
    return Result<Done>::failure(Issue{Severity::error, path, 0, "", "the pages could not be drawn", "try .html"});
  }
  return Result<Done>::failure(Issue{Severity::error, path, 0, "", "'" + suffix + "' is no format of a report", "use .html, .pdf, .xlsx or .csv"});
}

}  // namespace stemwise
