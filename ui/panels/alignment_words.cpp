#include "ui/panels/alignment_words.hpp"

#include <algorithm>

#include "ui/text/format.hpp"

namespace stemwise::ui {

std::string second_best_words(const Acceptance& acceptance) {
  if (acceptance.log_likelihood_ratio <= 0.0) return dash;
  const double share = acceptance.second_best / acceptance.log_likelihood_ratio;
  if (share < 0.005) return "no other pose fits";
  return percent_text(std::min(share, 1.0)) + " as good";
}

std::string observed_words(const ObservedDofs& observed) {
  static constexpr const char* names[] = {"x", "y", "yaw", "z", "roll", "pitch"};
  std::string words;
  for (std::size_t i = 0; i < observed.seen.size(); ++i) {
    if (observed.seen[i]) words += (words.empty() ? "" : " ") + std::string(names[i]);
  }
  return words.empty() ? "none" : words;
}

}  // namespace stemwise::ui
