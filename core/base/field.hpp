#pragma once
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/base/issue.hpp"

namespace stemwise {

/// One setting, told once: the key of `--set`, of the project file and of the settings form. `value` points into the
/// settings struct that made it.
struct Field {
  std::string key;   ///< "vote.cell_m"
  std::string unit;  ///< "m", "deg", "" for none
  std::string help;  ///< one sentence
  std::variant<double*, int*, bool*, std::string*> value;
};

using Fields = std::vector<Field>;

std::string field_text(const Field& field);
/// Sets the field named `key` from text; an issue when the key is unknown (the nearest key is named) or the text does not fit.
Issues set_field(std::span<const Field> fields, const std::string& key, const std::string& text);

}  // namespace stemwise
