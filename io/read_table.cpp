#include "io/read_table.hpp"

#include <array>

#include "io/delimited_text.hpp"
#include "io/stem_table.hpp"
#include "io/text_file.hpp"

namespace stemwise {
namespace {

constexpr std::array<char, 5> delimiters = {',', ';', '\t', '|', ' '};
constexpr std::size_t rows_sampled = 60;

/// The delimiter under which the file has the best header.
char sniff_delimiter(std::string_view text, const ReadOptions& options) {
  char best = 0;
  int best_score = 1;
  for (const char delimiter : delimiters) {
    const Grid sample = parse_delimited(text, delimiter, rows_sampled);
    for (const GridRow& row : sample.rows) {
      const int score = row.cells.size() > 1 ? header_score(row, options) : 0;
      if (score > best_score) {
        best_score = score;
        best = delimiter;
      }
    }
  }
  return best;
}

Issue no_header(const std::string& path, std::string_view text) {
  const std::string_view line = trimmed(text.substr(0, text.find_first_of("\r\n")));
  return {Severity::error, path, 1, {},
          "no header of a stem table was found; the file begins with \"" + std::string(line.substr(0, 80)) + "\"",
          "expected a row with column names such as x, y, dbh (or easting, northing; azimuth, distance), separated by comma, semicolon, tab, | or blanks"};
}

}  // namespace

Result<OpenedTable> open_text_table(const std::string& path, const ReadOptions& options) {
  const auto file = read_text_file(path);
  if (!file) return Result<OpenedTable>::failure(file.issues);
  const char delimiter = sniff_delimiter(file->text, options);
  if (delimiter == 0) return Result<OpenedTable>::failure(no_header(path, file->text));
  Grid grid = parse_delimited(file->text, delimiter);
  const auto header = find_header(grid, options);
  if (!header) return Result<OpenedTable>::failure(no_header(path, file->text));
  StemTable table = stem_table_from(std::move(grid), *header, path, delimiter == ',');
  table.notes.insert(table.notes.begin(), {"encoding: " + file->encoding, "delimiter: " + delimiter_name(delimiter)});
  return OpenedTable{std::move(table), std::nullopt, "table", {}};
}

}  // namespace stemwise
