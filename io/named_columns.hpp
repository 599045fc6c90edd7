#pragma once
#include <map>
#include <optional>
#include <string>

#include "core/base/issue.hpp"
#include "io/grid.hpp"
#include "io/number_style.hpp"

namespace stemwise {

/// Cells of a small table by the names in its first row (case does not matter), with an issue for every cell that is no number.
class NamedColumns {
 public:
  NamedColumns(std::string path, const Grid& grid);

  bool has(const char* name) const { return columns_.contains(name); }
  std::string cell(const GridRow& row, const char* name) const;  ///< "" where the row has none
  /// Of a text as this table writes its numbers: with a point, or with the comma that all of it uses.
  std::optional<double> number_of(const std::string& text) const;
  /// A number where the cell has one; an issue where it has something else, or nothing and the row needs it.
  std::optional<double> number(const GridRow& row, const char* name, bool needed);
  /// lat and lon in degrees; nothing, after an issue, where they are no position on the earth.
  std::optional<std::pair<double, double>> lat_lon(const GridRow& row);
  void bad_cell(const GridRow& row, const char* name, const std::string& text, const std::string& help);

  const std::string& path() const { return path_; }
  Issues& issues() { return issues_; }

 private:
  std::string path_;
  std::map<std::string, std::size_t> columns_;
  NumberStyle style_;
  Issues issues_;
};

/// Comma, semicolon or tab: what the first line has most of.
char likely_delimiter(const std::string& text);

}  // namespace stemwise
