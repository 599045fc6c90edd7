#pragma once
#include <array>
#include <optional>
#include <string>

namespace stemwise {

/// What became of a tree between two surveys (product.md, item 5). "Not surveyed" is never "dead": `missing` is missing
/// inside coverage, and only a person or a field code turns it into `dead` or `removed`.
enum class Fate { survivor, ingrowth, missed_earlier, missing, dead, removed, outside_coverage, unresolved };
inline constexpr std::size_t fate_count = 8;

const char* to_string(Fate fate);       ///< the word of cli.md
const char* fate_label(Fate fate);      ///< "Missing inside coverage"
std::string fate_in_sentence(Fate fate);  ///< "missing inside coverage"
std::optional<Fate> fate_from(const std::string& word);

}  // namespace stemwise
