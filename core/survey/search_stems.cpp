#include "core/survey/search_stems.hpp"

#include <algorithm>
#include <numeric>

namespace stemwise {

std::vector<std::size_t> search_stems(const Inventory& inventory, std::size_t most, std::span<const std::size_t> always) {
  std::vector<std::size_t> chosen(inventory.stems.size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  const bool made_of_frames = std::any_of(inventory.stems.begin(), inventory.stems.end(), [](const Stem& s) { return s.times_seen > 1; });
  if (!made_of_frames || chosen.size() <= most) return chosen;
  const auto worth = [&](std::size_t i) {
    const Stem& stem = inventory.stems[i];
    return (stem.reconstructed ? 1.0 : 0.1) * (stem.dbh_m ? 1.0 : 0.3) * stem.times_seen;
  };
  std::stable_sort(chosen.begin(), chosen.end(), [&](std::size_t a, std::size_t b) { return worth(a) > worth(b); });
  chosen.resize(most);
  chosen.insert(chosen.end(), always.begin(), always.end());
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

}  // namespace stemwise
