#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/base/date.hpp"

namespace stemwise {

/// The date in a file's or folder's name: "2023-05-04", "20230504", "2023" (mid-year). The last one that is a plausible date.
std::optional<Date> date_from_name(const std::string& path);
/// The median day; nothing when there are none.
std::optional<Date> median_date(std::vector<Date> dates);

/// Name of an inventory: the file's stem or the folder's name.
std::string inventory_name(const std::string& path);

}  // namespace stemwise
