#pragma once
#include <string>

namespace stemwise {

/// A number cell for print: a true minus sign. "20-80 %" and the like: an en dash between digits.
std::string print_number(const std::string& cell);
std::string print_prose(const std::string& text);

}  // namespace stemwise
