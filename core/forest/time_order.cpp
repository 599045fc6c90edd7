#include "core/forest/time_order.hpp"

#include <algorithm>

namespace stemwise {

std::vector<std::size_t> time_order(std::span<const std::optional<Date>> dates) {
  std::vector<std::size_t> dated;
  for (std::size_t i = 0; i < dates.size(); ++i)
    if (dates[i]) dated.push_back(i);
  std::stable_sort(dated.begin(), dated.end(), [&](std::size_t a, std::size_t b) { return *dates[a] < *dates[b]; });
  std::vector<std::size_t> order;
  auto next = dated.begin();
  for (std::size_t i = 0; i < dates.size(); ++i) order.push_back(dates[i] ? *next++ : i);
  return order;
}

}  // namespace stemwise
