#include "core/survey/grow_pose.hpp"

#include <numeric>

#include "core/survey/score_pose.hpp"

namespace stemwise {
namespace {

constexpr double growth = 1.5;       // of the radius, and of sigma: room for what the smaller circle could not see
constexpr double least_gain = 3.0;   // of the log-likelihood ratio from one circle to the next

Scene circle_around(const IndexedList& a, const Eigen::Vector2d& centre_m, double radius_m) {
  Scene circle;
  circle.centre_m = centre_m;
  circle.radius_m = radius_m;
  if (radius_m > (a.high_m - a.low_m).norm()) {
    circle.nodes.resize(a.size());
    std::iota(circle.nodes.begin(), circle.nodes.end(), std::size_t{0});
  } else {
    a.index.within(centre_m, radius_m, [&](std::size_t i, double) { circle.nodes.push_back(i); });
  }
  return circle;
}

}  // namespace

PoseFit grow_pose(const IndexedList& a, const Scene& scene, const IndexedList& b, PoseFit fit, double noise_floor_m, double convincing) {
  const bool may_stop = convincing > 0.0;
  double before = may_stop ? score_pose(a, b, fit, &scene).log_likelihood_ratio : 0.0;
  std::size_t count = scene.nodes.size();
  for (double radius_m = growth * scene.radius_m; count < a.size(); radius_m *= growth) {
    const Scene circle = circle_around(a, scene.centre_m, radius_m);
    count = circle.nodes.size();
    if (circle.nodes.empty()) continue;
    fit.noise_m *= growth;
    fit = refine_pose(a, circle.nodes, b, fit, noise_floor_m);
    fit.dbh = refit_dbh(a, circle.nodes, b, fit);
    if (!may_stop || count == a.size()) continue;
    const double now = score_pose(a, b, fit, &circle).log_likelihood_ratio;
    if (now < convincing && now < before + least_gain) break;
    before = now;
  }
  return fit;
}

}  // namespace stemwise
