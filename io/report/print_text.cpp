#include "io/report/print_text.hpp"

#include <cctype>

namespace stemwise {

std::string print_number(const std::string& cell) {
  std::string out;
  for (const char c : cell) out += c == '-' ? std::string("\u2212") : std::string(1, c);
  return out;
}

std::string print_prose(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool before = i > 0 && std::isdigit(static_cast<unsigned char>(text[i - 1]));
    const bool after = i + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[i + 1]));
    if (text[i] != '-' || !after) {
      out += text[i];
    } else if (!before) {
      out += "\u2212";
    } else {
      out += text.compare(i, 5, "-80 %") == 0 ? std::string("\u2013") : std::string("-");  // dates keep their hyphens
    }
  }
  return out;
}

}  // namespace stemwise
