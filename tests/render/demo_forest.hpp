#pragma once
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/random.hpp"
#include "core/project/commands.hpp"
#include "core/project/project.hpp"
#include "core/survey/tables.hpp"

namespace stemwise::test {

/// A made-up forest in three surveys with everything the pictures have to show: growth, ingrowth, missing trees, stems
/// outside one survey's coverage, tilted axes, hilly ground. The same for the same numbers.
class DemoForest {
 public:
  explicit DemoForest(int trees, bool is_aligned = true) {
    const double side_m = 4.6 * std::sqrt(static_cast<double>(trees));
    scatter(trees, side_m);
    for (int survey = 0; survey < 3; ++survey) project_.execute(add_inventory(survey_of(survey, side_m)));
    if (is_aligned) project_.execute(apply_alignment(alignment(), coverages(side_m)));
    tables_ = derive_tables(project_.state());
  }

  const Project& project() const { return project_; }
  const ProjectState& state() const { return project_.state(); }
  const Tables& tables() const { return tables_; }

 private:
  struct Tree {
    double x_m, y_m, dbh_m, growth_m_per_year;
    Eigen::Vector3d axis;
    bool in_survey[3];
    std::int64_t index[3];
  };

  static double ground_m(double x_m, double y_m) { return 250.0 + 6.0 * std::sin(x_m / 37.0) + 4.0 * std::cos(y_m / 29.0) + 0.05 * x_m; }

  void scatter(int trees, double side_m) {
    Random random(7);
    const int per_side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(trees))));
    for (int i = 0; i < trees; ++i) {
      Tree tree{};
      tree.x_m = side_m * 1.25 * ((i % per_side + random.uniform(0.12, 0.88)) / per_side);
      tree.y_m = side_m * 0.8 * ((i / per_side + random.uniform(0.12, 0.88)) / per_side);
      tree.dbh_m = 0.12 + 0.24 * std::pow(random.uniform(), 1.6) + (random.uniform() < 0.07 ? 0.25 * random.uniform() : 0.0);
      tree.growth_m_per_year = std::max(-0.001, random.normal(0.003, 0.0022));
      const double tilt = std::abs(random.normal(0.0, 0.05)), to = random.uniform(0.0, 2.0 * std::numbers::pi);
      tree.axis = {std::sin(tilt) * std::cos(to), std::sin(tilt) * std::sin(to), std::cos(tilt)};
      const double fate = random.uniform();
      tree.in_survey[0] = fate > 0.06;                       // else ingrowth
      tree.in_survey[1] = fate > 0.03 && fate < 0.97;
      tree.in_survey[2] = fate < 0.93 || fate > 0.985;       // else missing
      if (fate < 0.06) tree.dbh_m *= 0.5;
      trees_.push_back(tree);
    }
  }

  static bool is_covered(int survey, const Tree& tree, double side_m) {
    const double u = tree.x_m / (1.25 * side_m) - 0.5, v = tree.y_m / (0.8 * side_m) - 0.5;
    return survey < 2 || u * u / 0.2 + v * v / 0.2 < 1.0;
  }

  Inventory survey_of(int survey, double side_m) {
    Random random(100 + static_cast<std::uint64_t>(survey));
    const int years[3] = {2013, 2018, 2023};
    Inventory inventory;
    inventory.name = std::to_string(years[survey]);
    inventory.date = date_from_civil(years[survey], 5, 4);
    for (Tree& tree : trees_) {
      tree.index[survey] = -1;
      if (!tree.in_survey[survey] || !is_covered(survey, tree, side_m)) continue;
      tree.index[survey] = static_cast<std::int64_t>(inventory.stems.size());
      Stem stem;
      stem.source_id = std::to_string(inventory.stems.size() + 1);
      stem.x_m = tree.x_m + random.normal(0.0, 0.12);
      stem.y_m = tree.y_m + random.normal(0.0, 0.12);
      stem.z_m = ground_m(tree.x_m, tree.y_m) + random.normal(0.0, 0.05);
      stem.dbh_m = tree.dbh_m + 5.0 * survey * tree.growth_m_per_year + random.normal(0.0, 0.006);
      stem.axis = tree.axis;
      inventory.stems.push_back(stem);
    }
    return inventory;
  }

  SurveyAlignment alignment() const {
    SurveyAlignment result;
    result.reference = project_.state().reference;
    for (const auto& inventory : project_.state().inventories) {
      InventoryAlignment one;
      one.inventory = inventory->id;
      one.status = inventory->id == result.reference ? AlignmentStatus::reference : AlignmentStatus::aligned;
      one.position_noise_m = 0.12;
      result.inventories.push_back(one);
    }
    for (const Tree& tree : trees_)
      for (int a = 0; a < 2; ++a)
        for (int b = a + 1; b < 3 && tree.index[a] >= 0; ++b) {
          if (tree.index[b] < 0) continue;
          Match match{ref(a, tree), ref(b, tree)};
          const Stem &first = *project_.state().find(match.a), &second = *project_.state().find(match.b);
          match.distance_m = std::hypot(first.x_m - second.x_m, first.y_m - second.y_m);
          match.confidence = std::exp(-4.0 * match.distance_m * match.distance_m);
          result.matches.push_back(match);
          break;
        }
    return result;
  }

  StemRef ref(int survey, const Tree& tree) const { return {project_.state().inventories[static_cast<std::size_t>(survey)]->id, tree.index[survey]}; }

  std::vector<std::pair<InventoryId, Coverage>> coverages(double side_m) const {
    std::vector<std::pair<InventoryId, Coverage>> all;
    for (int survey = 0; survey < 3; ++survey) {
      Coverage coverage;
      const double width_m = 1.25 * side_m, height_m = 0.8 * side_m;
      for (int k = 0; k < 24; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 24;
        const double u = std::clamp((survey < 2 ? 2.0 : 0.447) * std::cos(angle), -0.51, 0.51);
        const double v = std::clamp((survey < 2 ? 2.0 : 0.447) * std::sin(angle), -0.51, 0.51);
        coverage.in_inventory.corners_m.push_back({width_m * (0.5 + u), height_m * (0.5 + v)});
      }
      all.emplace_back(project_.state().inventories[static_cast<std::size_t>(survey)]->id, coverage);
    }
    return all;
  }

  std::vector<Tree> trees_;
  Project project_;
  Tables tables_;
};

}  // namespace stemwise::test
