#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stemwise {

/// The shortest decimal text that reads back as the same double.
std::string exact_text(double value);
/// Numbers separated by blanks, each by exact_text.
std::string exact_list(std::span<const double> values);
/// Nothing when any part is no number.
std::optional<std::vector<double>> parse_exact_list(std::string_view text);
/// With that many digits behind the point, trailing zeros kept, "-0.00" never.
std::string fixed_text(double value, int decimals);

}  // namespace stemwise
