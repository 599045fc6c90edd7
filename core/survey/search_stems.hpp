#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/forest/inventory.hpp"

namespace stemwise {

/// The stems that the search for a pose looks at, ascending by index: of a list made of frames the best seen ones, at most
/// about `most` (those never reconstructed, or seen in passing, cost time and say little); of any other list all of them. `always` are in it in any case.
std::vector<std::size_t> search_stems(const Inventory& inventory, std::size_t most, std::span<const std::size_t> always);

}  // namespace stemwise
