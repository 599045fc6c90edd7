#pragma once
#include <optional>
#include <string>

#include "core/base/date.hpp"

namespace stemwise {

/// With so many decimals; never "-0.0".
std::string fixed(double value, int decimals);
/// "" without a value.
std::string fixed(const std::optional<double>& value, int decimals, double factor = 1.0);
/// "2019-05-04"; "" without a date.
std::string date_text(const std::optional<Date>& date);
/// "4,688".
std::string grouped(int value);

}  // namespace stemwise
