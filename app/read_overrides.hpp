#pragma once
#include <string>
#include <vector>

namespace stemwise {

/// What a person says about the inputs where their headers do not (cli.md, "Overrides"), as typed: each may begin with
/// "NAME:" to speak of one inventory only.
struct ReadOverrides {
  std::vector<std::string> names;        ///< instead of those from the paths; empty: from the paths
  std::vector<std::string> map;          ///< x=Easting
  std::vector<std::string> unit;         ///< dbh=mm
  std::vector<std::string> sheet;        ///< NAME
  std::vector<std::string> plot_column;  ///< C
  std::vector<std::string> plot;         ///< VALUE
  std::vector<std::string> date;         ///< 2023-05-04
  std::vector<std::string> status;       ///< K=dead
};

}  // namespace stemwise
