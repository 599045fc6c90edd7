#include "core/survey/vote_poses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/parallel.hpp"

namespace stemwise {
namespace {

constexpr double least_evidence = 0.25;     // pairs below it do not vote
constexpr double least_expected = 0.1;      // votes: E is floored here
constexpr double least_surprise = 3.0;      // a cell below it is no peak
constexpr double smoothing_m = 4.0;         // of the expectation
constexpr std::size_t expectation_yaws = 32;
constexpr std::size_t peaks_per_yaw = 8;
constexpr std::size_t yaws_per_task = 8;

/// The pairs of one query node that vote. Places in cells from the grid's corner.
struct Voters {
  float x_m = 0.0F, y_m = 0.0F;  ///< the query node from the scene's centre
  std::vector<float> x, y, weight;
};

struct Grid {
  double cell_m = 0.4;
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero();
  int columns = 0, rows = 0;
  std::size_t cells() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

struct CellPeak {
  float surprise = 0.0F;
  int yaw = 0, column = 0, row = 0;
  bool operator<(const CellPeak& o) const {  // best first, and never a tie
    if (surprise != o.surprise) return surprise > o.surprise;
    if (yaw != o.yaw) return yaw < o.yaw;
    return row != o.row ? row < o.row : column < o.column;
  }
};

Grid grid_for(const Scene& scene, const IndexedList& b) {
  Grid grid;
  const Eigen::Vector2d size = (b.high_m - b.low_m).array() + 2.0 * scene.radius_m;
  grid.cell_m = vote_cell_m(scene, b);
  grid.low_m = b.low_m.array() - scene.radius_m - 2.0 * grid.cell_m;
  grid.columns = static_cast<int>(size.x() / grid.cell_m) + 6;
  grid.rows = static_cast<int>(size.y() / grid.cell_m) + 6;
  return grid;
}

std::vector<Voters> voters_of(const IndexedList& a, const Scene& scene, const IndexedList& b, const DbhModel& model, const Grid& grid) {
  std::vector<Voters> result(scene.nodes.size());
  const double circle = 4.0 * std::numbers::pi * grid.cell_m * grid.cell_m;
  for (std::size_t k = 0; k < scene.nodes.size(); ++k) {
    const std::size_t i = scene.nodes[k];
    Voters& voters = result[k];
    voters.x_m = static_cast<float>(a.nodes.at_m[i].x() - scene.centre_m.x());
    voters.y_m = static_cast<float>(a.nodes.at_m[i].y() - scene.centre_m.y());
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double evidence = dbh_evidence(model, a.nodes.dbh_cm[i], b.nodes.dbh_cm[j], b.dbh_density_at[j]);
      if (evidence < least_evidence) continue;
      voters.x.push_back(static_cast<float>((b.nodes.at_m[j].x() - grid.low_m.x()) / grid.cell_m));
      voters.y.push_back(static_cast<float>((b.nodes.at_m[j].y() - grid.low_m.y()) / grid.cell_m));
      voters.weight.push_back(static_cast<float>(std::log1p(0.6 * evidence / (b.density_per_sq_m[j] * circle))));
    }
  }
  return result;
}

/// One plane of the vote: all shifts at one yaw.
void fill_plane(const std::vector<Voters>& voters, const Grid& grid, double yaw_rad, std::vector<float>& plane) {
  std::fill(plane.begin(), plane.end(), 0.0F);
  const auto scale = static_cast<float>(1.0 / grid.cell_m);
  const auto c = static_cast<float>(std::cos(yaw_rad)) * scale, s = static_cast<float>(std::sin(yaw_rad)) * scale;
  constexpr std::size_t block = 256;
  int place[block];
  for (const Voters& v : voters) {
    const float x = c * v.x_m - s * v.y_m, y = s * v.x_m + c * v.y_m;
    for (std::size_t first = 0; first < v.x.size(); first += block) {
      const std::size_t count = std::min(block, v.x.size() - first);
      const float* px = v.x.data() + first;
      const float* py = v.y.data() + first;
      const float* pw = v.weight.data() + first;
      for (std::size_t k = 0; k < count; ++k) place[k] = static_cast<int>(py[k] - y) * grid.columns + static_cast<int>(px[k] - x);
      for (std::size_t k = 0; k < count; ++k) plane[static_cast<std::size_t>(place[k])] += pw[k];
    }
  }
}

/// Mean over a square window along rows, then along columns.
std::vector<float> smoothed(std::vector<float> plane, const Grid& grid, int reach) {
  const auto pass = [reach](const float* from, float* to, int count, std::ptrdiff_t step) {
    double sum = 0.0;
    for (int k = 0; k < std::min(reach, count); ++k) sum += from[k * step];
    for (int k = 0; k < count; ++k) {
      if (k + reach < count) sum += from[(k + reach) * step];
      if (k - reach - 1 >= 0) sum -= from[(k - reach - 1) * step];
      to[k * step] = static_cast<float>(sum / (2 * reach + 1));
    }
  };
  std::vector<float> other(plane.size());
  for (int y = 0; y < grid.rows; ++y) pass(&plane[static_cast<std::size_t>(y) * grid.columns], &other[static_cast<std::size_t>(y) * grid.columns], grid.columns, 1);
  for (int x = 0; x < grid.columns; ++x) pass(&other[static_cast<std::size_t>(x)], &plane[static_cast<std::size_t>(x)], grid.rows, grid.columns);
  return plane;
}

/// What chance puts into four neighbouring cells: the mean over other yaws.
std::vector<float> expected_votes(const std::vector<Voters>& voters, const Grid& grid, const VoteSettings& settings, const Progress& progress) {
  constexpr std::size_t tasks = 4;  // fixed, so that sums are taken in one order at any thread count
  std::vector<std::vector<float>> sums(tasks, std::vector<float>(grid.cells(), 0.0F));
  parallel_for(tasks, settings.threads, [&](std::size_t task) {
    std::vector<float> plane(grid.cells());
    for (std::size_t k = task; k < expectation_yaws; k += tasks) {
      progress.check();
      fill_plane(voters, grid, 2.0 * std::numbers::pi * (static_cast<double>(k) + 0.37) / expectation_yaws, plane);
      for (std::size_t cell = 0; cell < plane.size(); ++cell) sums[task][cell] += plane[cell];
    }
  });
  for (std::size_t task = 1; task < tasks; ++task)
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) sums[0][cell] += sums[task][cell];
  auto expected = smoothed(std::move(sums[0]), grid, std::max(1, static_cast<int>(0.5 * smoothing_m / grid.cell_m)));
  for (float& e : expected) e = std::max(static_cast<float>(least_expected), 4.0F * e / static_cast<float>(expectation_yaws));
  return expected;
}

/// Votes that a cell needs to be a peak: the surprise is at most (V - E)^2 / 2E.
std::vector<float> peak_bounds(const std::vector<float>& expected, float least) {
  std::vector<float> bound(expected.size());
  for (std::size_t k = 0; k < bound.size(); ++k) bound[k] = expected[k] + std::sqrt(2.0F * least * expected[k]);
  return bound;
}

void keep_peak(std::vector<CellPeak>& best, const CellPeak& peak) {
  constexpr int apart = 3;  // cells
  for (auto& other : best)
    if (std::abs(other.column - peak.column) <= apart && std::abs(other.row - peak.row) <= apart) {
      if (peak < other) other = peak;
      return;
    }
  if (best.size() < peaks_per_yaw) return best.push_back(peak);
  auto& worst = *std::max_element(best.begin(), best.end());
  if (peak < worst) worst = peak;
}

/// What a cell must exceed, and where: the expectation and the bound that follows from the least surprise asked for.
struct Chance {
  std::vector<float> expected, bound;
  float least = 0.0F;
};

std::vector<CellPeak> peaks_of_plane(const std::vector<float>& plane, const Chance& chance, const Grid& grid, int yaw) {
  std::vector<CellPeak> best;
  std::vector<float> four(static_cast<std::size_t>(grid.columns), 0.0F);
  const auto width = static_cast<std::size_t>(grid.columns) - 1;
  for (int row = 0; row + 1 < grid.rows; ++row) {
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns);
    const float* here = &plane[start];
    const float* below = here + grid.columns;
    const float* bound = &chance.bound[start];
    int any = 0;  // one pass that the compiler can do many cells at a time; most rows end here
    for (std::size_t x = 0; x < width; ++x) {
      four[x] = (here[x] + here[x + 1]) + (below[x] + below[x + 1]);
      any |= four[x] > bound[x] ? 1 : 0;
    }
    if (any == 0) continue;
    for (std::size_t x = 0; x < width; ++x) {
      if (four[x] <= bound[x]) continue;
      const float e = chance.expected[start + x], surprise = four[x] * std::log(four[x] / e) - four[x] + e;
      if (surprise > chance.least) keep_peak(best, {surprise, yaw, static_cast<int>(x), row});
    }
  }
  return best;
}

/// The expectation, and how surprising a cell must be to be worth a look: less than what chance does in every other plane.
Chance chance_of(const std::vector<Voters>& voters, const Grid& grid, const VoteSettings& settings, const Progress& progress) {
  constexpr std::size_t probes = 7;
  Chance chance{expected_votes(voters, grid, settings, progress), {}, static_cast<float>(least_surprise)};
  chance.bound = peak_bounds(chance.expected, chance.least);
  std::vector<float> highest(probes, 0.0F);
  parallel_for(probes, settings.threads, [&](std::size_t k) {
    progress.check();
    std::vector<float> plane(grid.cells());
    fill_plane(voters, grid, 2.0 * std::numbers::pi * (static_cast<double>(k) + 0.61) / probes, plane);
    for (const auto& peak : peaks_of_plane(plane, chance, grid, 0)) highest[k] = std::max(highest[k], peak.surprise);
  });
  std::nth_element(highest.begin(), highest.begin() + probes / 2, highest.end());
  chance.least = std::max(chance.least, 0.7F * highest[probes / 2]);
  chance.bound = peak_bounds(chance.expected, chance.least);
  return chance;
}

std::vector<double> yaws_to_try(const Scene& scene, double cell_m, const std::optional<PoseWindow>& window) {
  const double step_rad = std::min(0.1, cell_m / std::max(scene.radius_m, cell_m));
  const double from = window ? window->b_from_a.yaw_rad - window->yaw_radius_rad : 0.0;
  const double span = window ? std::min(2.0 * window->yaw_radius_rad, 2.0 * std::numbers::pi) : 2.0 * std::numbers::pi;
  const auto count = static_cast<std::size_t>(std::ceil(span / step_rad)) + (window ? 1 : 0);
  std::vector<double> yaws;
  for (std::size_t k = 0; k < count; ++k) yaws.push_back(from + span * static_cast<double>(k) / static_cast<double>(count));
  return yaws;
}

PosePeak pose_of(const CellPeak& peak, const Grid& grid, double yaw_rad, const Eigen::Vector2d& centre_m) {
  const Eigen::Vector2d image = grid.low_m + grid.cell_m * Eigen::Vector2d(peak.column + 1.0, peak.row + 1.0);
  PlanarPose pose{0.0, 0.0, wrap_angle(yaw_rad)};
  const Eigen::Vector2d shift = image - pose * centre_m;
  pose.x_m = shift.x(), pose.y_m = shift.y();
  return {pose, peak.surprise};
}

/// Best first, none the neighbour of a better one.
std::vector<PosePeak> distinct_peaks(std::vector<CellPeak> found, const Grid& grid, const std::vector<double>& yaws, const Scene& scene, const VoteSettings& settings) {
  std::sort(found.begin(), found.end());
  std::vector<PosePeak> result;
  std::vector<CellPeak> kept;
  const int count = static_cast<int>(yaws.size());
  for (const CellPeak& peak : found) {
    if (result.size() >= static_cast<std::size_t>(settings.peaks)) break;
    const bool neighbour = std::any_of(kept.begin(), kept.end(), [&](const CellPeak& k) {
      const int turn = std::abs(k.yaw - peak.yaw);
      return std::min(turn, count - turn) <= 2 && std::abs(k.column - peak.column) <= 2 && std::abs(k.row - peak.row) <= 2;
    });
    if (neighbour) continue;
    const PosePeak pose = pose_of(peak, grid, yaws[static_cast<std::size_t>(peak.yaw)], scene.centre_m);
    if (settings.window) {
      const Eigen::Vector2d& about = settings.window->about_m;
      if ((pose.b_from_a * about - settings.window->b_from_a * about).norm() > settings.window->radius_m) continue;
    }
    kept.push_back(peak);
    result.push_back(pose);
  }
  return result;
}

}  // namespace

double vote_cell_m(const Scene& scene, const IndexedList& b) {
  constexpr double most_cells = 4e6, most_cells_and_yaws = 4e8;
  const Eigen::Vector2d size = (b.high_m - b.low_m).array() + 2.0 * scene.radius_m;
  const double area_sq_m = size.x() * size.y();
  return std::max({scene.cell_m, std::sqrt(area_sq_m / most_cells), std::cbrt(area_sq_m * 2.0 * std::numbers::pi * scene.radius_m / most_cells_and_yaws)});
}

std::vector<PosePeak> vote_poses(const IndexedList& a, const Scene& scene, const IndexedList& b, const DbhModel& model, const VoteSettings& settings, const Progress& progress) {
  if (scene.nodes.size() < 2 || b.size() < 2) return {};
  const Grid grid = grid_for(scene, b);
  const auto voters = voters_of(a, scene, b, model, grid);
  const Chance chance = chance_of(voters, grid, settings, progress);
  const auto yaws = yaws_to_try(scene, grid.cell_m, settings.window);
  const std::size_t tasks = (yaws.size() + yaws_per_task - 1) / yaws_per_task;
  std::vector<std::vector<CellPeak>> found(tasks);
  parallel_for(tasks, settings.threads, [&](std::size_t task) {
    std::vector<float> plane(grid.cells());
    for (std::size_t k = task * yaws_per_task; k < std::min(yaws.size(), (task + 1) * yaws_per_task); ++k) {
      progress.check();
      fill_plane(voters, grid, yaws[k], plane);
      const auto best = peaks_of_plane(plane, chance, grid, static_cast<int>(k));
      found[task].insert(found[task].end(), best.begin(), best.end());
    }
  });
  std::vector<CellPeak> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return distinct_peaks(std::move(all), grid, yaws, scene, settings);
}

}  // namespace stemwise
