#include "io/report/write_report.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "io/write_whole_file.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

Result<Done> not_writable(const std::string& path) {
  return Result<Done>::failure(Issue{Severity::error, path, 0, "", "cannot be written", "does the folder exist, and may you write there?"});
}

/// cairo writes files itself: beside `path`, renamed only when complete.
Result<Done> replace_pdf(const std::string& path, const ReportDocument& document) {
  const std::string beside = path + ".part" + std::to_string(getpid());
  std::error_code code;
  const bool complete = static_cast<bool>(write_report_pdf(beside, document));
  if (complete) fs::rename(beside, path, code);
  if (complete && !code) return Done{};
  fs::remove(beside, code);
  return not_writable(path);
}

}  // namespace

Result<Done> write_report(const std::string& path, const ReportDocument& document) {
  std::string suffix = fs::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".html" || suffix == ".htm") {
    return write_whole_file(path, report_html(document));
  }
  if (suffix == ".csv") {
    return write_whole_file(path, report_csv(document));
  }
  if (suffix == ".xlsx") return write_report_xlsx(path, document);
  if (suffix == ".pdf") return replace_pdf(path, document);
  return Result<Done>::failure(Issue{Severity::error, path, 0, "", "'" + suffix + "' is no format of a report", "use .html, .pdf, .xlsx or .csv"});
}

}  // namespace stemwise
