#include "io/read_frame_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <string_view>

#include "io/parse_decimal.hpp"
#include "io/read_whole_file.hpp"
#include "io/scan_decimal.hpp"

namespace stemwise {
namespace {

/// The columns we use, by place in a row's numbers.
enum Column : std::size_t {
  axis_x,
  axis_y,
  axis_z,
  location_x,
  location_y,
  location_z,
  dbh,
  dbh_approximation,
  score,
  reconstructed,
  clusters,
  column_count
};
struct ColumnName {
  std::string_view name;
  Column column;
};
constexpr std::array<ColumnName, 12> known_columns{{{"axis_02", axis_x},
                                                    {"axis_12", axis_y},
                                                    {"axis_22", axis_z},
                                                    {"location_x", location_x},
                                                    {"location_y", location_y},
                                                    {"location_z", location_z},
                                                    {"dbh", dbh},
                                                    {"dbh_approximation", dbh_approximation},
                                                    {"score", score},
                                                    {"scores", score},
                                                    {"reconstructed", reconstructed},
                                                    {"number_clusters", clusters}}};
constexpr std::size_t not_used = column_count;
constexpr double widest_dbh_m = 20.0;  // the widest stem on record has 12 m

struct Header {
  char delimiter = ',';
  std::vector<std::size_t> column_of_field;
  std::array<bool, column_count> present{};
  std::vector<std::string> names;
  bool has_axis() const { return present[axis_x] && present[axis_y] && present[axis_z]; }
};

/// One row's numbers; `given` says which of them the row has.
struct Row {
  std::array<double, column_count> value{};
  std::array<bool, column_count> given{};
};

std::string lower_trimmed(std::string_view text) {
  while (!text.empty() && (std::isspace(static_cast<unsigned char>(text.front())) || text.front() == '"')) text.remove_prefix(1);
  while (!text.empty() && (std::isspace(static_cast<unsigned char>(text.back())) || text.back() == '"')) text.remove_suffix(1);
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

Header read_header(std::string_view line) {
  if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  Header header;
  for (const char c : {';', '\t'}) {
    if (std::count(line.begin(), line.end(), c) > std::count(line.begin(), line.end(), header.delimiter)) header.delimiter = c;
  }
  while (true) {
    const std::size_t end = std::min(line.find(header.delimiter), line.size());
    const std::string name = lower_trimmed(line.substr(0, end));
    const auto known =
        std::find_if(known_columns.begin(), known_columns.end(), [&](const ColumnName& c) { return c.name == name; });
    const bool used = known != known_columns.end() && !header.present[known->column];
    if (used) header.present[known->column] = true;
    header.column_of_field.push_back(used ? static_cast<std::size_t>(known->column) : not_used);
    header.names.push_back(name);
    if (end == line.size()) return header;
    line.remove_prefix(end + 1);
  }
}

std::optional<double> read_flag(std::string_view text) {
  const std::string word = lower_trimmed(text);
  if (word == "true") return 1.0;
  if (word == "false") return 0.0;
  return std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

Issue bad_value(Issue place, const std::string& column, std::string_view value, const char* expected) {
  place.column = column;
  place.text = "'" + std::string(value) + "' is not " + expected + ": the row is left out";
  return place;
}

/// Reads the fields of one line. False, with an issue added, when the line is bad.
bool read_fields(std::string_view line, const Header& header, const Issue& place, Row& row, Issues& issues) {
  const char* at = line.data();
  const char* const end = at + line.size();
  std::size_t field = 0;
  for (; field < header.column_of_field.size(); ++field) {
    const auto* stop = static_cast<const char*>(std::memchr(at, header.delimiter, static_cast<std::size_t>(end - at)));
    const std::size_t column = header.column_of_field[field];
    if (column != not_used) {
      const std::string_view text(at, static_cast<std::size_t>((stop == nullptr ? end : stop) - at));
      auto number = parse_decimal(text);
      if (!number && column == reconstructed) number = read_flag(text);
      if (!number && !trimmed(text).empty()) {
        issues.push_back(
            bad_value(place, header.names[field], trimmed(text), column == reconstructed ? "true or false" : "a finite number"));
        return false;
      }
      row.given[column] = number.has_value();
      row.value[column] = number.value_or(0.0);
    }
    if (stop == nullptr) break;
    at = stop + 1;
  }
  if (field + 1 >= header.column_of_field.size()) return true;
  Issue issue = place;
  issue.text =
      std::to_string(field + 1) + " fields instead of " + std::to_string(header.column_of_field.size()) + ": the row is left out";
  issues.push_back(std::move(issue));
  return false;
}

/// True or False, in the spelling that a frame folder has most often.
ScannedDecimal scan_flag(const char* at) {
  const auto begins = [at](std::string_view word) {
    std::size_t same = 0;
    while (same < word.size() && at[same] == word[same]) ++same;
    return same == word.size();
  };
  if (begins("True")) return {at + 4, 1.0, true};
  return begins("False") ? ScannedDecimal{at + 5, 0.0, true} : ScannedDecimal{};
}

/// The fast path for a row without fault: plain numbers and empty fields, all of them there. The row's fields, and where the
/// next line begins; null for any other row, good or bad: that is for read_fields. Needs a line end at the text's end.
const char* read_clean_row(const char* at, const Header& header, Row& row) {
  const std::size_t fields = header.column_of_field.size();
  for (std::size_t field = 0; field < fields; ++field) {
    const std::size_t column = header.column_of_field[field];
    if (column == not_used) {
      at = find_either(at, header.delimiter, '\n');
    } else if (*at != header.delimiter && *at != '\n' && *at != '\r') {
      ScannedDecimal number = scan_decimal(at);
      if (!number.clean && column == reconstructed) number = scan_flag(at);
      if (!number.clean) return nullptr;
      row.value[column] = number.value;
      row.given[column] = true;
      at = number.end;
    }
    if (field + 1 < fields && *at++ != header.delimiter) return nullptr;
  }
  if (*at == '\r') ++at;
  return *at == '\n' ? at + 1 : nullptr;
}

/// What is wrong with a row whose fields are numbers; nothing when it is a stem.
std::optional<Issue> check_row(const Row& row, const Header& header, const Issue& place) {
  for (const Column c : {location_x, location_y}) {
    if (!row.given[c]) return bad_value(place, c == location_x ? "location_x" : "location_y", "", "a number");
  }
  for (const Column c : {dbh, dbh_approximation}) {
    const double d = row.value[c];
    if (!row.given[c] || (d > 0.0 && d < widest_dbh_m)) continue;
    return bad_value(place, c == dbh ? "dbh" : "dbh_approximation", std::to_string(d), "a diameter in metres (0 to 20)");
  }
  if (!header.has_axis() || !(row.given[axis_x] && row.given[axis_y] && row.given[axis_z])) return std::nullopt;
  const double length = std::sqrt(row.value[axis_x] * row.value[axis_x] + row.value[axis_y] * row.value[axis_y] +
                                  row.value[axis_z] * row.value[axis_z]);
  if (std::abs(length - 1.0) <= 0.05) return std::nullopt;
  Issue issue = place;
  issue.column = "axis_02 axis_12 axis_22";
  issue.text = "the axis has length " + std::to_string(length) + ", not 1: the row is left out";
  return issue;
}

void fill_stem(Stem& stem, const Row& row, const Header& header, std::int64_t line_number) {
  stem.source_id = std::to_string(line_number);
  stem.source_row = line_number;
  stem.x_m = row.value[location_x];
  stem.y_m = row.value[location_y];
  if (row.given[location_z]) stem.z_m = row.value[location_z];
  if (row.given[dbh]) stem.dbh_m = row.value[dbh];
  if (row.given[dbh_approximation]) stem.dbh_approximation_m = row.value[dbh_approximation];
  if (header.has_axis() && row.given[axis_x] && row.given[axis_y] && row.given[axis_z]) {
    Eigen::Vector3d axis(row.value[axis_x], row.value[axis_y], row.value[axis_z]);
    axis.normalize();
    stem.axis = axis.z() < 0.0 ? Eigen::Vector3d(-axis) : axis;  // upwards
  }
  if (row.given[reconstructed]) stem.reconstructed = row.value[reconstructed] != 0.0;
  if (row.given[score]) stem.score = row.value[score];
  if (row.given[clusters]) stem.number_clusters = static_cast<int>(std::clamp(row.value[clusters], 0.0, 1e6));
}

std::optional<Issue> missing_column(const Header& header, const std::string& path) {
  const bool has_dbh = header.present[dbh] || header.present[dbh_approximation];
  const char* missing = !header.present[location_x]   ? "location_x"
                        : !header.present[location_y] ? "location_y"
                        : !has_dbh                    ? "dbh"
                                                      : nullptr;
  if (missing == nullptr) return std::nullopt;
  return Issue{Severity::error,
               path,
               1,
               missing,
               std::string("there is no column ") + missing,
               "expected a header with location_x, location_y and dbh or dbh_approximation"};
}

/// By memchr, which looks at whole vectors: rows are long.
std::size_t count_lines(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) ++count;
  return count;
}

/// The rows of a text that ends with a line end behind its end.
class RowReader {
public:
  RowReader(std::string_view rows, const Header& header, const std::string& path)
      : rest_(rows), header_(header), place_{Severity::warning, path, 0, "", "", ""} {
    stems_.reserve(count_lines(rows) + 1);
  }

  Result<std::vector<Stem>> read() {
    for (line_number_ = 2; !rest_.empty(); ++line_number_) {
      Row row;
      if (const char* next = read_clean_row(rest_.data(), header_, row)) {
        rest_.remove_prefix(std::min(static_cast<std::size_t>(next - rest_.data()), rest_.size()));
        take(row);
      } else {
        read_carefully();
      }
    }
    return {std::move(stems_), std::move(issues_)};
  }

private:
  void read_carefully() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (trimmed(line).empty()) return;
    Row row;
    if (read_fields(line, header_, place_, row, issues_)) {
      take(row);
    } else {
      issues_.back().row = line_number_;
    }
  }

  void take(const Row& row) {
    if (auto issue = check_row(row, header_, place_)) {
      issue->row = line_number_;
      issues_.push_back(std::move(*issue));
    } else {
      fill_stem(stems_.emplace_back(), row, header_, line_number_);
    }
  }

  std::string_view rest_;
  const Header& header_;
  Issue place_;
  std::int64_t line_number_ = 0;
  std::vector<Stem> stems_;
  Issues issues_;
};

}  // namespace

Result<std::vector<Stem>> read_frame_file(const std::string& path) {
  using Stems = std::vector<Stem>;
  const auto bytes = read_whole_file(path);
  if (!bytes) return Result<Stems>::failure({Severity::error, path, 0, "", "the file cannot be read", ""});
  std::string_view rest = bytes->text();
  const std::size_t header_end = std::min(rest.find('\n'), rest.size());
  const Header header = read_header(rest.substr(0, header_end));
  if (const auto missing = missing_column(header, path)) return Result<Stems>::failure(*missing);
  rest.remove_prefix(std::min(header_end + 1, rest.size()));
  return RowReader(rest, header, path).read();
}

}  // namespace stemwise
