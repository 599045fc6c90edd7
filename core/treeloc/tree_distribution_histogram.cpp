#include "core/treeloc/tree_distribution_histogram.hpp"

namespace stemwise::treeloc {
namespace {

/// Mean of each cell and its neighbours before it, the border repeated.
std::vector<float> smoothed(const std::vector<float>& h, std::size_t rows, std::size_t columns) {
  std::vector<float> out(h.size());
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t above = r > 0 ? r - 1 : 0, left = c > 0 ? c - 1 : 0;
      out[r * columns + c] =
          0.25F * (h[r * columns + c] + h[above * columns + c] + h[r * columns + left] + h[above * columns + left]);
    }
  }
  return out;
}

}  // namespace

Fields TdhSettings::fields(const std::string& prefix) {
  return {{prefix + ".enabled", "", "Use the tree distribution histogram in retrieval", &enabled},
          {prefix + ".radial_bins", "", "Bins of distance from the origin", &radial_bins},
          {prefix + ".radial_width_m", "m", "Width of a distance bin", &radial_width_m},
          {prefix + ".radial_overlap_m", "m", "What a distance bin is widened by on both sides", &radial_overlap_m},
          {prefix + ".dbh_bins", "", "Bins of diameter; the last one is open", &dbh_bins},
          {prefix + ".dbh_step_m", "m", "Distance between the starts of two diameter bins", &dbh_step_m},
          {prefix + ".dbh_width_m", "m", "Width of a diameter bin", &dbh_width_m},
          {prefix + ".count_once", "", "A tree in two overlapping bins counts in the first one only", &count_once}};
}

std::vector<float> tree_distribution_histogram(const Scene& scene, const TdhSettings& settings) {
  const auto rows = static_cast<std::size_t>(settings.radial_bins), columns = static_cast<std::size_t>(settings.dbh_bins);
  std::vector<float> h(rows * columns, 0.0F);
  const double widened_m = settings.count_once ? 0.0 : settings.radial_overlap_m;
  for (const SceneTree& tree : scene.trees) {
    const double range_m = tree.position_m.head<2>().norm();
    for (std::size_t r = 0; r < rows; ++r) {
      const double from_m = static_cast<double>(r) * settings.radial_width_m;
      if (range_m < from_m - widened_m || range_m >= from_m + settings.radial_width_m + widened_m) continue;
      for (std::size_t c = 0; c < columns; ++c) {
        const double least_m = static_cast<double>(c) * settings.dbh_step_m;
        if (tree.dbh_m < least_m || (tree.dbh_m >= least_m + settings.dbh_width_m && c + 1 < columns)) continue;
        h[r * columns + c] += 1.0F;
        if (settings.count_once) break;
      }
    }
  }
  return smoothed(h, rows, columns);
}

}  // namespace stemwise::treeloc
