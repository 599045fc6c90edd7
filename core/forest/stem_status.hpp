#pragma once
#include <optional>
#include <string_view>

namespace stemwise {

/// What the field crew wrote of a stem. `missing`: the crew looked and did not find it; that is no sighting, so such rows are left
/// out when a file is read and no stem of an inventory has it.
enum class StemStatus { alive, dead, unknown, removed, missing };
inline constexpr std::size_t stem_status_count = 5;

/// Neither dead nor taken away, as far as anyone said.
constexpr bool is_living(StemStatus status) { return status != StemStatus::dead && status != StemStatus::removed; }

const char* to_string(StemStatus status);  ///< "alive"
std::optional<StemStatus> stem_status_from(std::string_view word);

}  // namespace stemwise
