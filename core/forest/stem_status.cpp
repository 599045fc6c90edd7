#include "core/forest/stem_status.hpp"

#include <array>

namespace stemwise {
namespace {
constexpr std::array<const char*, stem_status_count> words{"alive", "dead", "unknown", "removed", "missing"};
}

const char* to_string(StemStatus status) { return words[static_cast<std::size_t>(status)]; }

std::optional<StemStatus> stem_status_from(std::string_view word) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (word == words[i]) return static_cast<StemStatus>(i);
  return std::nullopt;
}

}  // namespace stemwise
