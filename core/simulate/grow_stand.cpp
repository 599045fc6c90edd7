#include "core/simulate/grow_stand.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace stemwise {
namespace {

constexpr std::array species_names{"Picea abies", "Fagus sylvatica", "Abies alba", "Acer pseudoplatanus"};

/// Points in cells, for "is anything within r" while points are still being added.
class Neighbours {
 public:
  explicit Neighbours(double cell_m) : cell_m_(cell_m) {}
  void add(std::size_t tree, double x, double y) { cells_[key(cell(x), cell(y))].push_back({tree, x, y}); }
  template <class Blocks>
  bool any(double x, double y, double radius_m, Blocks&& blocks) const {
    for (int v = cell(y - radius_m); v <= cell(y + radius_m); ++v)
      for (int u = cell(x - radius_m); u <= cell(x + radius_m); ++u) {
        const auto found = cells_.find(key(u, v));
        if (found == cells_.end()) continue;
        for (const auto& p : found->second)
          if (blocks(p.tree, std::hypot(p.x - x, p.y - y))) return true;
      }
    return false;
  }

 private:
  struct Point {
    std::size_t tree;
    double x, y;
  };
  int cell(double v) const { return static_cast<int>(std::floor(v / cell_m_)); }
  static std::int64_t key(int u, int v) { return (static_cast<std::int64_t>(u) << 32) ^ static_cast<std::uint32_t>(v); }
  double cell_m_;
  std::unordered_map<std::int64_t, std::vector<Point>> cells_;
};

/// Shape 1.3, like an uneven-aged stand: many small stems, a long tail.
double weibull(Random& random, double scale, double shape) { return scale * std::pow(-std::log(1.0 - random.uniform()), 1.0 / shape); }

Eigen::Vector3d leaning_axis(Random& random, double lean_sd_rad) {
  return Eigen::Vector3d(random.normal(0.0, lean_sd_rad), random.normal(0.0, lean_sd_rad), 1.0).normalized();
}

TrueTree tree_at(double x_m, double y_m, double dbh_cm, const Terrain* terrain, Random& random) {
  TrueTree tree;
  tree.x_m = x_m, tree.y_m = y_m;
  if (terrain != nullptr) tree.z_m = terrain->height_m(x_m, y_m);
  tree.axis = leaning_axis(random, 0.035);
  const double u = random.uniform();
  tree.species = species_names[u < 0.45 ? 0 : u < 0.75 ? 1 : u < 0.9 ? 2 : 3];
  tree.then.push_back({TrueState::alive, dbh_cm, ""});
  return tree;
}

double room_m(double dbh_a_cm, double dbh_b_cm) { return 0.4 + 0.022 * (dbh_a_cm + dbh_b_cm); }

std::vector<TrueTree> natural_stand(const SimulateSettings& s, double side_m, const Terrain& terrain, Random& random) {
  std::vector<double> dbh_cm;
  for (int i = 0; i < s.stems; ++i) dbh_cm.push_back(std::min(s.smallest_dbh_cm + weibull(random, 17.0, 1.3), 130.0));
  std::sort(dbh_cm.rbegin(), dbh_cm.rend());
  const Terrain clumps = random_terrain(2.0, random);  // the same waves, as a density
  Neighbours neighbours(4.0);
  std::vector<TrueTree> trees;
  for (const double d : dbh_cm) {
    double x = 0.0, y = 0.0, ease = 1.0, dbh = d;
    for (int attempt = 0; attempt < 400; ++attempt, ease *= attempt % 20 == 19 ? 0.85 : 1.0) {
      x = random.uniform(0.0, side_m), y = random.uniform(0.0, side_m);
      if (random.uniform() > std::exp(0.7 * (clumps.height_m(x, y) - 1.0))) continue;
      const double widest = ease * room_m(d, 130.0);
      if (!neighbours.any(x, y, widest, [&](std::size_t t, double r) { return r < ease * room_m(d, trees[t].then[0].dbh_cm); })) break;
    }
    if (!trees.empty() && random.uniform() < 0.03) {  // a second stem of the tree before it, at one spot
      const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
      x = trees.back().x_m + 0.25 * std::cos(angle), y = trees.back().y_m + 0.25 * std::sin(angle);
      dbh = std::max(s.smallest_dbh_cm, d * random.uniform(0.3, 1.0));  // SCBI-ForestGEO 2013: deciles .30, .41, ... .87, .93
    }
    neighbours.add(trees.size(), x, y);
    trees.push_back(tree_at(x, y, dbh, &terrain, random));
  }
  return trees;
}

std::vector<TrueTree> planted_stand(const SimulateSettings& s, double side_m, const Terrain& terrain, Random& random) {
  const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(s.stems))));
  const double spacing_m = side_m / rows;
  std::vector<TrueTree> trees;
  for (int i = 0; static_cast<int>(trees.size()) < s.stems; ++i) {
    const double x = (i % rows + 0.5) * spacing_m + random.normal(0.0, 0.08), y = (i / rows + 0.5) * spacing_m + random.normal(0.0, 0.08);
    trees.push_back(tree_at(x, y, std::max(s.smallest_dbh_cm, random.normal(24.0, 3.0)), &terrain, random));
    trees.back().species = species_names[0];
  }
  return trees;
}

/// Where a patch was felled this time: a circle around one of the trees.
struct Patch {
  double x_m = 0.0, y_m = 0.0, radius_m = 0.0;
  bool contains(const TrueTree& t) const { return std::hypot(t.x_m - x_m, t.y_m - y_m) < radius_m; }
};

Patch felled_patch(const std::vector<TrueTree>& trees, double years, const SimulateSettings& s, Random& random) {
  double x1 = trees[0].x_m, x0 = x1, y1 = trees[0].y_m, y0 = y1;
  for (const auto& t : trees) x0 = std::min(x0, t.x_m), x1 = std::max(x1, t.x_m), y0 = std::min(y0, t.y_m), y1 = std::max(y1, t.y_m);
  const double share = 0.5 * s.removals_per_year * years;  // the other half falls tree by tree
  const TrueTree& middle = trees[random.below(trees.size())];
  return {middle.x_m, middle.y_m, std::sqrt(share * (x1 - x0) * (y1 - y0) / std::numbers::pi)};
}

TreeThen next_state(const TrueTree& tree, double years, const SimulateSettings& s, bool in_patch, Random& random) {
  const TreeThen& before = tree.then.back();
  const double vigour = std::exp(random.normal(0.0, 0.5)), removal = random.uniform(), death = random.uniform();
  if (before.state != TrueState::alive) return {before.state, before.dbh_cm, ""};
  if (in_patch || removal < 1.0 - std::exp(-0.5 * s.removals_per_year * years)) return {TrueState::removed, before.dbh_cm, ""};
  const double frailty = before.dbh_cm < 15.0 ? 1.6 : 0.8;
  if (death < 1.0 - std::exp(-frailty * s.mortality_per_year * years)) return {TrueState::dead, before.dbh_cm, ""};
  const double size = std::clamp(0.55 + 0.02 * before.dbh_cm, 0.55, 1.4);
  return {TrueState::alive, before.dbh_cm + s.growth_cm_per_year * size * vigour * years, ""};
}

}  // namespace

double Terrain::height_m(double x_m, double y_m) const {
  double z = 0.0;
  for (const Wave& w : waves) z += w.height_m * std::sin(w.east_per_m * x_m + w.north_per_m * y_m + w.phase_rad);
  return z;
}

Terrain random_terrain(double relief_m, Random& random) {
  Terrain terrain;
  constexpr int waves = 5;
  for (int k = 0; k < waves; ++k) {
    const double length_m = random.uniform(60.0, 250.0), heading = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double per_m = 2.0 * std::numbers::pi / length_m;
    terrain.waves.push_back({per_m * std::cos(heading), per_m * std::sin(heading), random.uniform(0.0, 2.0 * std::numbers::pi),
                             relief_m / (2.0 * std::sqrt(static_cast<double>(waves)))});
  }
  return terrain;
}

std::vector<TrueTree> first_stand(const SimulateSettings& settings, double side_m, const Terrain& terrain, Random& random) {
  return settings.planted ? planted_stand(settings, side_m, terrain, random) : natural_stand(settings, side_m, terrain, random);
}

void let_years_pass(std::vector<TrueTree>& trees, double years, const SimulateSettings& settings, const Terrain* terrain, Random& random) {
  if (trees.empty()) return;
  const Patch patch = felled_patch(trees, years, settings, random);
  const std::size_t surveys = trees[0].then.size();
  double x1 = trees[0].x_m, x0 = x1, y1 = trees[0].y_m, y0 = y1;
  std::size_t alive = 0;
  for (auto& tree : trees) {
    x0 = std::min(x0, tree.x_m), x1 = std::max(x1, tree.x_m), y0 = std::min(y0, tree.y_m), y1 = std::max(y1, tree.y_m);
    alive += tree.then.back().state == TrueState::alive ? 1U : 0U;
    tree.then.push_back(next_state(tree, years, settings, patch.contains(tree), random));
  }
  const auto grown_in = static_cast<std::size_t>(settings.ingrowth_per_year * years * static_cast<double>(alive));
  Neighbours neighbours(4.0);
  for (std::size_t i = 0; i < trees.size(); ++i) neighbours.add(i, trees[i].x_m, trees[i].y_m);
  for (std::size_t k = 0; k < grown_in; ++k) {
    double x = 0.0, y = 0.0;
    for (int attempt = 0; attempt < 40; ++attempt) {
      x = random.uniform(x0, x1), y = random.uniform(y0, y1);
      if (!neighbours.any(x, y, 1.0, [](std::size_t, double r) { return r < 1.0; })) break;
    }
    const double dbh_cm = settings.smallest_dbh_cm + settings.growth_cm_per_year * years * random.uniform();
    neighbours.add(trees.size(), x, y);
    trees.push_back(tree_at(x, y, dbh_cm, terrain, random));
    trees.back().then.insert(trees.back().then.begin(), surveys, TreeThen{});
  }
}

}  // namespace stemwise
