#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace stemwise {

enum class Severity { note, warning, error };

/// One thing that a person should know about an input or a piece of work. `row` is 1-based and counts the lines of the
/// file as an editor shows them (the header is row 1); 0 and empty mean "not about one place".
struct Issue {
  Severity severity = Severity::warning;
  std::string file;
  std::int64_t row = 0;
  std::string column;
  std::string text;  ///< what is wrong, with the value met and what was expected
  std::string help;  ///< what the person can do; may be empty

  bool operator==(const Issue&) const = default;
};

using Issues = std::vector<Issue>;

/// "plot.csv, row 12, column dbh: ..." in one line, help behind it.
std::string to_string(const Issue& issue);
bool has_error(const Issues& issues);

}  // namespace stemwise
