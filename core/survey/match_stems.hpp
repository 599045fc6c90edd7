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

/// What species say: with labels that agree as often as those of sure matches do, beyond what chance agrees. Labels are
/// numbers; negative: not known, which says nothing.
struct SpeciesEvidence {
  std::vector<int> of_a, of_b;       ///< per stem; both empty: species are not compared
  double same = 0.0, other = 0.0;    ///< ln of how much likelier the labels are for one tree than for two
  double log_ratio(std::size_t a, std::size_t b) const {
    if (of_a.empty() || of_b.empty() || of_a[a] < 0 || of_b[b] < 0) return 0.0;
    return of_a[a] == of_b[b] ? same : other;
  }
};

/// What is expected before two stems are compared.
struct MatchPriors {
  double share_a = 0.5, share_b = 0.5;  ///< chance of a stem of b to be in a, and of one of a to be in b
  std::vector<double> presence_a;       ///< each stem of a's own chance to be in b, where not empty (a tree not seen for long has less)
  SpeciesEvidence species;
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
/// ln(1 - pB) for every stem left alone; globally optimal. Stems without DBH are matched by position alone.
std::vector<StemMatch> match_stems(const IndexedList& a, const IndexedList& b, const PoseFit& fit, const MatchPriors& priors, const MatchConstraints& constraints);

}  // namespace stemwise
