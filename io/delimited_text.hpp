#pragma once
#include <string>
#include <string_view>

#include "io/grid.hpp"

namespace stemwise {

/// Splits text at `delimiter` (',', ';', tab, '|', or ' ' for runs of blanks) and at line ends of any kind. Fields in double
/// quotes may hold delimiters, line ends and doubled quotes; a quote that is never closed is an ordinary character. At most
/// `max_rows` rows.
Grid parse_delimited(std::string_view text, char delimiter, std::size_t max_rows = static_cast<std::size_t>(-1));

/// "semicolon", for people.
std::string delimiter_name(char delimiter);

/// Without blanks (also no-break ones) at either end.
std::string_view trimmed(std::string_view text);

}  // namespace stemwise
