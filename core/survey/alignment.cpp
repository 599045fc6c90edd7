#include "core/survey/alignment.hpp"

namespace stemwise {
namespace {
constexpr std::array<const char*, 5> status_words{"unaligned", "reference", "aligned", "probable", "failed"};
constexpr std::array<const char*, 4> match_words{"automatic", "accepted", "rejected", "linked"};

template <class Enum, std::size_t N>
std::optional<Enum> from_word(const std::array<const char*, N>& words, const std::string& word) {
  for (std::size_t i = 0; i < N; ++i)
    if (word == words[i]) return static_cast<Enum>(i);
  return std::nullopt;
}
}  // namespace

const char* to_string(AlignmentStatus status) { return status_words[static_cast<std::size_t>(status)]; }
std::optional<AlignmentStatus> alignment_status_from(const std::string& word) { return from_word<AlignmentStatus>(status_words, word); }
const char* to_string(MatchState state) { return match_words[static_cast<std::size_t>(state)]; }
std::optional<MatchState> match_state_from(const std::string& word) { return from_word<MatchState>(match_words, word); }

}  // namespace stemwise
