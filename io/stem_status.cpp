#include "io/stem_status.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace stemwise {
namespace {

constexpr std::array<std::string_view, 24> alive_words = {"a", "l", "li", "lb", "alive", "live", "living", "true", "yes", "y", "t", "vivo",
                                                          "viva", "vivant", "vif", "lebend", "lebt", "elava", "as", "ll", "au", "liv", "survivor", "healthy"};
constexpr std::array<std::string_view, 28> dead_words = {"d", "dead", "sn", "snag", "dn", "dc", "ds", "dt", "g", "gone", "false", "no",
                                                         "n", "mort", "morte", "muerto", "muerta", "morto", "tot", "kuollut", "stem dead", "log", "stump",
                                                         "f", "cut", "removed", "missing", "stem gone"};

template <class Words>
bool is_in(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

StemStatus stem_status_from(std::string_view code, bool numbers_from_one) {
  std::string word;
  for (const char c : code) word.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  if (word == "1" || word == "1.0") return StemStatus::alive;
  if (word == "0" || word == "0.0") return numbers_from_one ? StemStatus::unknown : StemStatus::dead;
  if (word == "2" || word == "3") return numbers_from_one ? StemStatus::dead : StemStatus::unknown;
  if (is_in(alive_words, word)) return StemStatus::alive;
  if (is_in(dead_words, word) || word.starts_with("dead") || word.starts_with("gone")) return StemStatus::dead;
  if (word.starts_with("alive") || word.starts_with("live")) return StemStatus::alive;
  return StemStatus::unknown;
}

}  // namespace stemwise
