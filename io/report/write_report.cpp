#include "io/report/write_report.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace stemwise {
namespace {

namespace fs = std::filesystem;

Result<Done> not_writable(const std::string& path) {
  return Result<Done>::failure(Issue{Severity::error, path, 0, "", "cannot be written", "does the folder exist, and may you write there?"});
}

/// `fill` writes to the path it is given; what it wrote takes the place of `path` only when it is complete.
template <class Fill>
Result<Done> replace_file(const std::string& path, Fill fill) {
  const std::string beside = path + ".part" + std::to_string(getpid());
  std::error_code code;
  const bool complete = fill(beside);
  if (complete) fs::rename(beside, path, code);
  if (complete && !code) return Done{};
  fs::remove(beside, code);
  return not_writable(path);
}

bool write_text(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  return static_cast<bool>(out);
}

}  // namespace

Result<Done> write_report(const std::string& path, const ReportDocument& document) {
  std::string suffix = fs::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (suffix == ".html" || suffix == ".htm") {
    return replace_file(path, [&](const std::string& to) { return write_text(to, report_html(document)); });
  }
  if (suffix == ".csv") {
    return replace_file(path, [&](const std::string& to) { return write_text(to, report_csv(document)); });
  }
  if (suffix == ".pdf") {
    return replace_file(path, [&](const std::string& to) { return static_cast<bool>(write_report_pdf(to, document)); });
  }
  return Result<Done>::failure(Issue{Severity::error, path, 0, "", "'" + suffix + "' is no format of a report", "use .html, .pdf or .csv"});
}

}  // namespace stemwise
