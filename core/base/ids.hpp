#pragma once
#include <compare>
#include <cstdint>
#include <functional>

namespace stemwise {

/// A number that cannot be mistaken for another kind of number. 0 means "none".
template <class Tag>
struct Id {
  std::int64_t value = 0;
  auto operator<=>(const Id&) const = default;
  explicit operator bool() const { return value != 0; }
};

using InventoryId = Id<struct InventoryTag>;
using TreeId = Id<struct TreeTag>;

/// One stem of one inventory: its place in `Inventory::stems`, which never changes after reading.
struct StemRef {
  InventoryId inventory;
  std::int64_t index = -1;
  auto operator<=>(const StemRef&) const = default;
};

}  // namespace stemwise

template <class Tag>
struct std::hash<stemwise::Id<Tag>> {
  std::size_t operator()(stemwise::Id<Tag> id) const { return std::hash<std::int64_t>{}(id.value); }
};
template <>
struct std::hash<stemwise::StemRef> {
  std::size_t operator()(const stemwise::StemRef& s) const {
    return std::hash<std::int64_t>{}(s.inventory.value * 0x9E3779B97F4A7C15LL + s.index);
  }
};
