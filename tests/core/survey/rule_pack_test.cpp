#include "core/survey/rule_pack.hpp"

#include <gtest/gtest.h>

namespace stemwise {
namespace {

/// DBHs in mm as the published rules tell them.
RuleCase mm(double earlier, double later, double years) { return {earlier / 1000.0, later / 1000.0, years, 0.0, 0.0, ""}; }

const Rule& rule(const char* pack, const std::string& flag) {
  for (const Rule& one : find_rule_pack(pack)->rules)
    if (one.flag == flag) return one;
  throw std::logic_error(flag);
}

TEST(RulePack, CtfsShrinkageIsFourOfItsStandardDeviationsOfThePairWhateverTheYears) {
  const Rule& shrinkage = rule("ctfs", "ctfs_shrinkage");
  const double limit_mm = 4.0 * (0.006214 * 200.0 + 0.9036);  // 8.5856
  EXPECT_EQ(judge(shrinkage, mm(200, 200 - limit_mm + 0.01, 5)), Verdict::fine);
  EXPECT_EQ(judge(shrinkage, mm(200, 200 - limit_mm - 0.01, 5)), Verdict::broken);
  EXPECT_EQ(judge(shrinkage, mm(200, 200 - limit_mm - 0.01, 50)), Verdict::broken);
}

TEST(RulePack, CtfsGrowthIsSeventyFiveMillimetresAYear) {
  const Rule& growth = rule("ctfs", "ctfs_growth");
  EXPECT_EQ(judge(growth, mm(200, 200 + 5 * 74.9, 5)), Verdict::fine);
  EXPECT_EQ(judge(growth, mm(200, 200 + 5 * 75.1, 5)), Verdict::broken);
  RuleCase undated = mm(200, 900, 1);
  undated.years.reset();
  EXPECT_EQ(judge(growth, undated), Verdict::not_judged);
}

TEST(RulePack, ForestGeoJudgesStemsOfTenMillimetresAndMoreByTheYear) {
  const Rule& growth = rule("forestgeo", "forestgeo_growth");
  const Rule& shrinkage = rule("forestgeo", "forestgeo_shrinkage");
  EXPECT_EQ(judge(growth, mm(100, 100 + 4 * 65.1, 4)), Verdict::broken);
  EXPECT_EQ(judge(growth, mm(100, 100 + 4 * 64.9, 4)), Verdict::fine);
  EXPECT_EQ(judge(shrinkage, mm(100, 80, 4)), Verdict::broken);    // exactly 5 % a year counts
  EXPECT_EQ(judge(shrinkage, mm(100, 80.2, 4)), Verdict::fine);
  EXPECT_EQ(judge(shrinkage, mm(9.9, 5, 1)), Verdict::not_judged);
  EXPECT_EQ(judge(growth, mm(9.9, 500, 1)), Verdict::not_judged);
}

TEST(RulePack, ScbiComparesTheTwoDiametersOfThePair) {
  EXPECT_EQ(judge(rule("scbi", "scbi_shrinkage"), mm(100, 74.9, 5)), Verdict::broken);
  EXPECT_EQ(judge(rule("scbi", "scbi_shrinkage"), mm(100, 75.1, 5)), Verdict::fine);
  EXPECT_EQ(judge(rule("scbi", "scbi_growth"), mm(100, 192.1, 5)), Verdict::broken);
  EXPECT_EQ(judge(rule("scbi", "scbi_growth"), mm(100, 191.9, 5)), Verdict::fine);
}

TEST(RulePack, TreeDataGivesPioneersMoreRoom) {
  RuleCase pioneer = mm(100, 100 + 2 * 60, 2);
  pioneer.species = "cecropia obtusa";
  RuleCase other = pioneer;
  other.species = "Eperua falcata";
  EXPECT_EQ(judge(rule("treedata", "treedata_growth"), other), Verdict::broken);
  EXPECT_EQ(judge(rule("treedata", "treedata_growth"), pioneer), Verdict::not_judged);
  EXPECT_EQ(judge(rule("treedata", "treedata_growth_pioneer"), pioneer), Verdict::fine);
  pioneer.later_dbh_m = 0.100 + 2 * 0.076;
  EXPECT_EQ(judge(rule("treedata", "treedata_growth_pioneer"), pioneer), Verdict::broken);
  EXPECT_EQ(judge(rule("treedata", "treedata_shrinkage"), mm(300, 279, 5)), Verdict::broken);
  EXPECT_EQ(judge(rule("treedata", "treedata_shrinkage"), mm(300, 281, 5)), Verdict::fine);
}

TEST(RulePack, TheLidarPackIsCtfsForPerfectSurveysAndWiderForPoorOnes) {
  const RuleCase sharp = mm(200, 200 - 9, 5);
  EXPECT_EQ(judge(rule("lidar", "lidar_shrinkage"), sharp), Verdict::broken);
  RuleCase poor = sharp;
  poor.earlier_error_m = 0.01;
  poor.later_error_m = 0.03;
  EXPECT_EQ(judge(rule("lidar", "lidar_shrinkage"), poor), Verdict::fine);
  poor.later_dbh_m = 0.2 - 4.0 * std::hypot(0.006214 * 0.2 + 0.0009036, std::hypot(0.01, 0.03)) - 1e-6;
  EXPECT_EQ(judge(rule("lidar", "lidar_shrinkage"), poor), Verdict::broken);
  RuleCase fast = mm(200, 200 + 2 * 80, 2);
  EXPECT_EQ(judge(rule("lidar", "lidar_growth"), fast), Verdict::broken);
  fast.earlier_error_m = fast.later_error_m = 0.03;
  EXPECT_EQ(judge(rule("lidar", "lidar_growth"), fast), Verdict::fine);
}

TEST(RulePack, AnOwnRuleSurvivesItsTextAndSaysWhatIsWrongWithABrokenOne) {
  const auto own = rule_from_text("flag=too_fast;meaning=no spruce does that;growth_above_cm_per_year=3;least_dbh_cm=1;species=Picea,Abies;sd_slope=0.01;sd_times=3");
  ASSERT_TRUE(own);
  EXPECT_DOUBLE_EQ(*own->growth_above_m_per_year, 0.03);
  EXPECT_EQ(to_text(*rule_from_text(to_text(*own))), to_text(*own));
  EXPECT_EQ(own->species, (std::vector<std::string>{"Picea", "Abies"}));
  EXPECT_FALSE(rule_from_text("flag=two words;ratio_below=0.5"));
  EXPECT_FALSE(rule_from_text("flag=nothing"));
  EXPECT_FALSE(rule_from_text("flag=x;ratio_below=half"));
  EXPECT_FALSE(rule_from_text("flag=x;ratio_bellow=0.5"));
}

}  // namespace
}  // namespace stemwise
