#include "core/treeloc/paired_tests.hpp"

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/treeloc/session_pairs.hpp"

namespace stemwise::treeloc {
namespace {

std::vector<QueryRow> rows_with(std::size_t count, double share_positive, double error_m, std::uint64_t seed) {
  Random random(seed);
  std::vector<QueryRow> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    rows[i].query = static_cast<std::int64_t>(i);
    rows[i].candidate = 1;
    rows[i].positive = random.uniform() < share_positive;
    rows[i].score = (rows[i].positive ? 0.5 : 0.1) + 0.2 * random.uniform();
    rows[i].error.position_m = {error_m * random.normal(), error_m * random.normal(), 0.0};
    rows[i].error.angle_deg = {0.3 * random.normal(), 0.0, 0.0};
  }
  return rows;
}

TEST(McNemarTest, IsTheExactBinomialProbability) {
  std::vector<char> a(20, 1), b(20, 1);
  for (int i = 0; i < 9; ++i) b[static_cast<std::size_t>(i)] = 0;
  a[15] = 0;
  const McNemar test = exact_mcnemar(a, b);
  EXPECT_EQ(test.only_a, 9);
  EXPECT_EQ(test.only_b, 1);
  EXPECT_NEAR(test.p, 2.0 * (1.0 + 10.0) / 1024.0, 1e-12);
  EXPECT_EQ(exact_mcnemar(a, a).p, 1.0);
}

TEST(WilcoxonTest, IsExactForFewPairsAndMatchesTheTables) {
  const std::vector<double> zero(8, 0.0);
  const std::vector<double> up{1, 2, 3, 4, 5, 6, 7, 8}, mixed{-1, 2, -3, 4, 5, 6, 7, 8};
  EXPECT_NEAR(wilcoxon_signed_rank(up, zero).p, 2.0 / 256.0, 1e-12);
  EXPECT_EQ(wilcoxon_signed_rank(up, zero).rank_sum, 36.0);
  // W- = 4: 7 of the 256 signings have a sum up to 4 (0; 1; 2; 3, 1+2; 4, 1+3).
  EXPECT_NEAR(wilcoxon_signed_rank(mixed, zero).p, 2.0 * 7.0 / 256.0, 1e-12);
  EXPECT_EQ(wilcoxon_signed_rank(zero, zero).p, 1.0);
}

TEST(WilcoxonTest, SeesAShiftAmongManyPairsAndNoneWhereThereIsNone) {
  Random random(3);
  std::vector<double> a, b, c;
  for (int i = 0; i < 300; ++i) {
    a.push_back(random.normal());
    b.push_back(random.normal());
    c.push_back(b.back() + 0.5);
  }
  EXPECT_GT(wilcoxon_signed_rank(a, b).p, 0.01);
  EXPECT_LT(wilcoxon_signed_rank(a, c).p, 1e-4);
  EXPECT_LT(wilcoxon_signed_rank(a, c).median_difference, -0.2);
}

TEST(CompareMethods, FindsTheBetterOneAndIsTheSameForTheSameSeed) {
  const auto good = rows_with(300, 0.98, 0.05, 1), poor = rows_with(300, 0.8, 0.15, 2);
  const PairedComparison c = compare_methods(good, poor, {}, 200, 7), again = compare_methods(good, poor, {}, 200, 7),
                         other = compare_methods(good, poor, {}, 200, 8);
  EXPECT_EQ(c.queries, 300U);
  EXPECT_LT(c.recall_at_1.p, 1e-6);
  EXPECT_GT(c.recall_at_1.only_a, c.recall_at_1.only_b);
  EXPECT_LT(c.position_m.p, 1e-6);
  EXPECT_LT(c.position_m.median_difference, 0.0);
  ASSERT_EQ(c.differences.front().figure, "recall_at_1");
  EXPECT_GT(c.differences.front().low, 0.05);
  EXPECT_LT(c.differences.front().low, c.differences.front().difference);
  EXPECT_GT(c.differences.front().high, c.differences.front().difference);
  bool differs = false;
  for (std::size_t f = 0; f < c.differences.size(); ++f) {
    EXPECT_EQ(c.differences[f].low, again.differences[f].low);
    differs = differs || c.differences[f].low != other.differences[f].low;
  }
  EXPECT_TRUE(differs);
}

TEST(CompareMethods, JoinsByQueryAndAMethodIsNoBetterThanItself) {
  const auto rows = rows_with(100, 0.9, 0.1, 1);
  const std::vector<QueryRow> later(rows.begin() + 40, rows.end());
  const PairedComparison c = compare_methods(rows, later, {}, 50, 1);
  EXPECT_EQ(c.queries, 60U);
  EXPECT_EQ(c.recall_at_1.p, 1.0);
  for (const auto& d : c.differences) EXPECT_EQ(d.low, 0.0) << d.figure;
}

TEST(Stability, IsTheLogOfMeanOverDeviation) {
  const std::vector<double> values{0.8, 0.9, 1.0};
  const Stability s = stability_of(values);
  EXPECT_NEAR(s.mean, 0.9, 1e-12);
  EXPECT_NEAR(s.sd, std::sqrt(0.02 / 3.0), 1e-12);
  EXPECT_NEAR(s.stability, std::log(0.9 / (s.sd + 1e-6)), 1e-12);
}

TEST(Thresholds, ChosenOnOneEvaluationAreMeasuredOnTheOthers) {
  std::vector<Evaluation> evaluations(3);
  evaluations[0].rows = rows_with(200, 0.9, 0.1, 1);
  evaluations[1].rows = rows_with(200, 0.9, 0.1, 2);
  evaluations[2].rows = rows_with(200, 0.9, 0.1, 3);
  for (QueryRow& row : evaluations[2].rows) row.score *= 0.5;  // another scale of scores
  const auto transfers = transfer_thresholds(evaluations, 1000);
  ASSERT_EQ(transfers.size(), 3U);
  EXPECT_EQ(transfers[0].f1_there, 1.0);
  EXPECT_GT(transfers[0].threshold, 0.29);
  EXPECT_LT(transfers[0].threshold, 0.51);
  EXPECT_LT(transfers[0].worst_f1_elsewhere, 0.95);
  const AtThreshold all = at_threshold(evaluations[0].rows, 0.0);
  EXPECT_EQ(all.accepted, 200);
  EXPECT_EQ(all.recall, 1.0);
  EXPECT_NEAR(all.precision, 1.0 - all.wrong / 200.0, 1e-12);
}

}  // namespace
}  // namespace stemwise::treeloc
