#include "core/survey/accept_pose.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace stemwise {
namespace {

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

std::string figures(const Acceptance& a) {
  return "best score " + number(a.log_likelihood_ratio) + ", second best " + number(a.second_best) + ", mirrored " + number(a.mirror) + ", chance alone " +
         number(a.log_poses_tried);
}

bool leads(const Acceptance& a, double ratio, double margin, double margin_share) {
  return a.log_likelihood_ratio - a.log_poses_tried >= ratio && a.margin >= std::max(margin, margin_share * a.log_likelihood_ratio);
}

}  // namespace

Verdict accept_pose(const Acceptance& a, const ListSettings& s) {
  if (leads(a, s.accept_log_ratio, s.accept_margin, s.margin_share)) return {AlignmentStatus::aligned, ""};
  if (a.mirror - a.log_poses_tried >= s.accept_log_ratio && a.mirror - a.log_likelihood_ratio >= std::max(s.accept_margin, s.margin_share * a.mirror))
    return {AlignmentStatus::failed, "mirrored, or axes swapped: the mirror image of this inventory fits, itself does not (" + figures(a) + ")"};
  if (leads(a, s.probable_log_ratio, s.probable_margin, s.margin_share))
    return {AlignmentStatus::probable, "a probable pose, to be looked at: it stands out, but not by enough to be sure (" + figures(a) + ")"};
  if (a.log_likelihood_ratio - a.log_poses_tried >= s.probable_log_ratio)
    return {AlignmentStatus::failed, "several poses fit about as well: " + figures(a) + "; a planted grid, or a repeating pattern, fits many ways"};
  return {AlignmentStatus::failed, "no pose stands out: " + figures(a) + "; fewer than about 11 trees in common, or different stands"};
}

double acceptance_probability(const Acceptance& a) {
  const double over_chance = a.log_likelihood_ratio - a.log_poses_tried;
  const double weakest = std::min(over_chance, a.margin);  // the rivals were tried as well
  return 1.0 / (1.0 + std::exp(-std::clamp(weakest, -700.0, 700.0)));
}

}  // namespace stemwise
