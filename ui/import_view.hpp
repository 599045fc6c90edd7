#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/issue.hpp"
#include "core/forest/stem.hpp"

namespace stemwise::ui {

/// What a person has said about one file that is to be read. Everything empty: as recognised.
struct ImportSettings {
  bool take = true;                                ///< false: this file is left out
  std::string name;
  std::map<std::string, std::string> columns;      ///< our name of a column -> the file's header; "": not read
  std::map<std::string, std::string> units;        ///< our name of a column -> m, cm, in, ...
  std::map<std::string, StemStatus> status_codes;
  std::string sheet, plot_column, plot;
  std::optional<Date> date;
  std::string no_date;                             ///< what was typed for the date and is none: stays in its field
  std::optional<int> epsg;
  bool operator==(const ImportSettings&) const = default;
};

struct ImportColumn {
  std::string kind;    ///< our name of it: "dbh"
  std::string header;
  std::string unit;    ///< empty where it has none
  std::string how;     ///< "by header", "median 31.5"
  bool guessed = false;
};

struct ImportCode {
  std::string code;
  std::int64_t rows = 0;
  StemStatus meaning = StemStatus::unknown;
};

/// One file as it will be understood.
struct ImportFile {
  std::string path, file_name, format;
  ImportSettings settings;
  bool reading = false;       ///< being read again after a change
  bool usable = false;
  bool remembered = false;    ///< settings come from an earlier file with the same header
  std::string name;           ///< of the inventory
  std::optional<Date> date;
  std::optional<int> epsg;
  std::string system;         ///< "WGS 84 / UTM zone 32N"
  std::int64_t stem_count = 0, row_count = 0;
  std::vector<std::string> sheets, header, plot_columns, plots;
  std::string sheet, plot_column;
  std::vector<ImportColumn> columns;
  std::vector<ImportCode> codes;
  std::vector<std::string> notes;
  std::vector<std::int64_t> row_numbers;
  std::vector<std::vector<std::string>> rows;  ///< the first ones, as the file has them
  std::vector<Stem> stems;                     ///< the first ones, as they are understood
  Issues issues;                               ///< worst first
  std::string command_line;                    ///< the same for `stemwise align`: "--unit dbh=mm"

  const ImportColumn* column(const std::string& kind) const {
    for (const ImportColumn& c : columns) {
      if (c.kind == kind) return &c;
    }
    return nullptr;
  }
};

}  // namespace stemwise::ui
