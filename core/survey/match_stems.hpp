#pragma once
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/survey/score_pose.hpp"

namespace stemwise {

/// What a person has decided, by index into both lists.
struct MatchConstraints {
  std::vector<std::pair<std::size_t, std::size_t>> must;
  std::vector<std::pair<std::size_t, std::size_t>> must_not;
};

/// Two stems held to be one, by index.
struct StemMatch {
  std::size_t a = 0;
  std::size_t b = 0;
  double gain = 0.0;        ///< how much likelier than leaving both alone, ln
  double confidence = 0.0;  ///< 0..1: against the second choices of both, and against being alone
  bool by_hand = false;
  std::optional<std::size_t> second_a;  ///< the other stem of a that b could have been
  std::optional<std::size_t> second_b;  ///< the other stem of b that a could have been; only the better of the two is set
};

/// Step 8 of stem-lists.md: the sparse one-to-one assignment that maximises the sum of l over pairs plus ln(1 - pA) or
/// ln(1 - pB) for every stem left alone; globally optimal. `presence_a`, where not empty, is each stem of a's own chance to
/// be in b (a tree not seen for long has less). Stems without DBH are matched by position alone.
std::vector<StemMatch> match_stems(const IndexedList& a, const IndexedList& b, const PoseFit& fit, double share_a, double share_b, const std::vector<double>& presence_a,
                                   const MatchConstraints& constraints);

}  // namespace stemwise
