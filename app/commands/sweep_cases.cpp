#include "app/commands/sweep_cases.hpp"

#include <algorithm>
#include <cmath>

namespace stemwise {
namespace {

std::string number(double value) {
  std::string text = std::to_string(std::round(value * 1e4) / 1e4);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

SweepCase switched(const std::string& what, const std::string& name, SettingTexts settings) {
  SweepCase c;
  c.what = what;
  c.name = name;
  c.settings = std::move(settings);
  return c;
}

/// The paper's ablations of the published pipeline (its section IV-H).
std::vector<SweepCase> published_ablations() {
  const auto off = [](const std::string& name, SettingTexts settings) { return switched("ablations", name, std::move(settings)); };
  return {off("all", {}),
          off("without TDH", {{"tdh.enabled", "false"}}),
          off("without PDH", {{"pdh.enabled", "false"}}),
          off("without TDH and PDH", {{"tdh.enabled", "false"}, {"pdh.enabled", "false"}}),
          off("set instead of multiset", {{"retrieve.multiset", "false"}}),
          off("without spatial penalty", {{"overlap.penalty", "false"}}),
          off("without DBH filter", {{"outliers.dbh_filter", "false"}}),
          off("without yaw voting", {{"outliers.yaw_voting", "false"}}),
          off("without DBH filter and yaw voting", {{"outliers.dbh_filter", "false"}, {"outliers.yaw_voting", "false"}}),
          off("without preceding frames", {{"scene.preceding_frames", "0"}}),
          off("without axis alignment", {{"axes.enabled", "false"}}),
          off("without IRLS", {{"planar.irls", "false"}}),
          off("without roll and pitch from axes", {{"roll_pitch.enabled", "false"}}),
          off("without joint vertical correction", {{"vertical.joint", "false"}})};
}

std::vector<SweepCase> default_ablations() {
  const auto off = [](const std::string& name, SettingTexts settings) { return switched("ablations", name, std::move(settings)); };
  return {off("all", {}),
          off("without orientation in the key", {{"triangles.orientation", "false"}}),
          off("with area in the key", {{"triangles.area", "true"}}),
          off("without displacement gate", {{"vote.gate_m", "100"}}),
          off("without DBH in the vote", {{"vote.tau_dbh_m", "10"}}),
          off("without DBH in pairing", {{"match.tau_dbh_m", "10"}}),
          off("one pairing step", {{"match.steps", "1"}, {"match.coarse_m", "0.4"}}),
          off("10 verified", {{"vote.verified", "10"}}),
          off("without choice by displacement", {{"verify.strong_share", "1"}}),
          off("without propagation", {{"verify.propagate_most", "0"}}),
          off("without preceding frames", {{"scene.preceding_frames", "0"}}),
          off("without filling to 30 trees", {{"scene.target_tree_count", "0"}}),
          off("without axis alignment", {{"axes.enabled", "false"}}),
          off("without robust weights (IRLS)", {{"refine.iterations", "1"}, {"refine.planar_scale_m", "100"}}),
          off("without height prior", {{"refine.height_prior", "false"}}),
          off("without fusion of poses", {{"fuse.enabled", "false"}})};
}

std::vector<SweepCase> deletions() {
  std::vector<SweepCase> cases;
  for (int percent = 0; percent <= 50; percent += 10) {
    SweepCase& c = cases.emplace_back(switched("deletion", std::to_string(percent) + " % of the trees deleted", {}));
    c.deleted_share = 0.01 * percent;
    c.is_random = percent > 0;
  }
  return cases;
}

std::vector<SweepCase> noises() {
  std::vector<SweepCase> cases{switched("noise", "none", {})};
  for (const char* target : {"centres", "DBH", "both"}) {
    for (const int cm : {1, 3, 5}) {
      SweepCase& c = cases.emplace_back(switched("noise", std::to_string(cm) + " cm on " + target, {}));
      if (target != std::string("DBH")) c.center_noise_m = 0.01 * cm;
      if (target != std::string("centres")) c.dbh_noise_m = 0.01 * cm;
      c.is_random = true;
    }
  }
  return cases;
}

/// Yaw in steps of 30 degrees, roll and pitch together in steps of 15 (the paper's section IV-G).
std::vector<SweepCase> rotations() {
  std::vector<SweepCase> cases;
  for (int deg = -180; deg <= 180; deg += 30)
    cases.emplace_back(switched("rotation", "yaw " + std::to_string(deg) + " deg", {})).map_turned.yaw_rad = radians(deg);
  for (int deg = -90; deg <= 90; deg += 15) {
    SweepCase& c = cases.emplace_back(switched("rotation", "roll and pitch " + std::to_string(deg) + " deg", {}));
    c.map_turned.roll_rad = c.map_turned.pitch_rad = radians(deg);
  }
  return cases;
}

std::vector<SweepCase> values_of(const std::string& what, const std::string& key, const std::vector<double>& values, const char* unit) {
  std::vector<SweepCase> cases;
  for (const double v : values) cases.push_back(switched(what, number(v) + " " + unit, {{key, number(v)}}));
  return cases;
}

/// Every main setting a quarter smaller and larger.
std::vector<SweepCase> quarters(treeloc::Method method, treeloc::Settings plain) {
  const std::vector<const char*> keys =
      method == treeloc::Method::stemwise
          ? std::vector<const char*>{"scene.local_radius_m", "scene.target_tree_count", "triangles.neighbours", "triangles.step_m",
                                     "vote.tau_dbh_m", "vote.gate_m", "vote.verified", "match.coarse_m", "match.fine_m", "match.tau_dbh_m",
                                     "verify.strong_share", "verify.propagate_radius_m", "verify.penalty_m", "refine.planar_scale_m",
                                     "refine.height_scale_m", "refine.axis_scale_deg", "refine.tilt_prior_deg", "refine.height_prior_m",
                                     "refine.height_bias_m", "fuse.position_scale_m", "fuse.rotation_scale_deg"}
          : std::vector<const char*>{"scene.local_radius_m", "scene.target_tree_count", "triangles.neighbours", "triangles.step_m",
                                     "retrieve.kept_by_histograms", "retrieve.verified", "outliers.tau_dbh_m", "planar.huber_m",
                                     "match.fine_m", "vertical.inlier_m", "overlap.sigma_t_m"};
  std::vector<SweepCase> cases{switched("defaults", "defaults", {})};
  const Fields fields = plain.fields();
  for (const char* key : keys) {
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.key == key; });
    for (const double factor : {0.75, 1.25}) {
      std::string text;
      if (auto* const* d = std::get_if<double*>(&field->value)) text = number(std::min(**d * factor, key == std::string("verify.strong_share") ? 1.0 : 1e9));
      if (auto* const* i = std::get_if<int*>(&field->value)) text = std::to_string(std::lround(**i * factor));
      cases.push_back(switched("defaults", std::string(key) + " " + (factor < 1.0 ? "-25 %" : "+25 %") + " (" + text + ")", {{key, text}}));
    }
  }
  return cases;
}

}  // namespace

std::vector<std::string> sweep_names() { return {"ablations", "deletion", "noise", "rotation", "radius", "sigma_t", "defaults"}; }

std::vector<SweepCase> sweep_cases(const std::string& what, treeloc::Method method, treeloc::Settings plain) {
  const bool is_default = method == treeloc::Method::stemwise;
  if (what == "ablations") return is_default ? default_ablations() : published_ablations();
  if (what == "deletion") return deletions();
  if (what == "noise") return noises();
  if (what == "rotation") return rotations();
  if (what == "radius") return values_of(what, "scene.local_radius_m", {10, 15, 20, 25, 30, 35, 40}, "m");
  if (what == "sigma_t") return values_of(what, is_default ? "verify.penalty_m" : "overlap.sigma_t_m", {1, 2.5, 5, 7.5, 10, 15}, "m");
  if (what == "defaults") return quarters(method, std::move(plain));
  return {};
}

}  // namespace stemwise
