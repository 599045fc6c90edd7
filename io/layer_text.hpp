#pragma once
#include <string>

#include "io/layer.hpp"

namespace stemwise {

struct TextTableStyle {
  char delimiter = ',';
  bool decimal_comma = false;
};

/// A layer as delimited text with a header row, line ends "\n", numbers with their columns' decimals. A polygon layer gets a
/// last column `wkt`.
std::string layer_text(const Layer& layer, const TextTableStyle& style);

/// Quoted where it must be.
std::string text_field(const std::string& text, char delimiter);

}  // namespace stemwise
