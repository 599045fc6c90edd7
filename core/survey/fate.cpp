#include "core/survey/fate.hpp"

namespace stemwise {
namespace {
constexpr std::array<const char*, fate_count> words{"survivor", "ingrowth", "missed_earlier",   "missing",
                                                    "dead",     "removed",  "outside_coverage", "unresolved"};
constexpr std::array<const char*, fate_count> labels{"Survivor", "Ingrowth", "Missed earlier",   "Missing inside coverage",
                                                     "Dead",     "Removed",  "Outside coverage", "Unresolved"};
}  // namespace

const char* to_string(Fate fate) { return words[static_cast<std::size_t>(fate)]; }
const char* fate_label(Fate fate) { return labels[static_cast<std::size_t>(fate)]; }

std::string fate_in_sentence(Fate fate) {
  std::string text = fate_label(fate);
  text.front() = static_cast<char>(text.front() - 'A' + 'a');
  return text;
}

std::optional<Fate> fate_from(const std::string& word) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (word == words[i]) return static_cast<Fate>(i);
  return std::nullopt;
}

}  // namespace stemwise
