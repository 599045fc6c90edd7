#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/date.hpp"

namespace stemwise {

/// The order in time of surveys of which some may have no date: those with dates by them, those without where they were
/// given (cli.md: "inventories without dates in the order given"). Indices into `dates`; equal dates stay as given.
std::vector<std::size_t> time_order(std::span<const std::optional<Date>> dates);

}  // namespace stemwise
