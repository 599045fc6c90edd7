#include "core/survey/assign_sparse.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/base/random.hpp"

namespace stemwise {
namespace {

double gain_of(const std::vector<AssignmentEdge>& edges, const std::vector<std::size_t>& chosen) {
  double sum = 0.0;
  std::set<std::size_t> lefts, rights;
  for (const std::size_t k : chosen) {
    EXPECT_TRUE(lefts.insert(edges[k].left).second);
    EXPECT_TRUE(rights.insert(edges[k].right).second);
    sum += edges[k].gain;
  }
  return sum;
}

/// By trying everything.
double best_gain(const std::vector<AssignmentEdge>& edges, std::size_t from, std::set<std::size_t>& lefts, std::set<std::size_t>& rights) {
  if (from == edges.size()) return 0.0;
  double best = best_gain(edges, from + 1, lefts, rights);
  const auto& e = edges[from];
  if (lefts.contains(e.left) || rights.contains(e.right)) return best;
  lefts.insert(e.left), rights.insert(e.right);
  best = std::max(best, e.gain + best_gain(edges, from + 1, lefts, rights));
  lefts.erase(e.left), rights.erase(e.right);
  return best;
}

TEST(AssignSparse, finds_what_trying_everything_finds) {
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    const std::size_t lefts = 1 + random.below(6), rights = 1 + random.below(6);
    std::vector<AssignmentEdge> edges;
    for (std::size_t l = 0; l < lefts; ++l)
      for (std::size_t r = 0; r < rights; ++r)
        if (random.uniform() < 0.5) edges.push_back({l, r, random.uniform(-1.0, 3.0)});
    std::set<std::size_t> used_l, used_r;
    EXPECT_NEAR(gain_of(edges, assign_sparse(lefts, rights, edges)), best_gain(edges, 0, used_l, used_r), 1e-9);
  }
}

TEST(AssignSparse, gives_up_a_good_pair_for_two_that_are_better_together) {
  const std::vector<AssignmentEdge> edges{{0, 0, 5.0}, {0, 1, 4.0}, {1, 0, 4.0}};
  EXPECT_DOUBLE_EQ(gain_of(edges, assign_sparse(2, 2, edges)), 8.0);
}

TEST(AssignSparse, leaves_alone_who_gains_nothing) {
  const std::vector<AssignmentEdge> edges{{0, 0, -0.5}, {1, 1, 0.0}};
  EXPECT_TRUE(assign_sparse(2, 2, edges).empty());
}

}  // namespace
}  // namespace stemwise
