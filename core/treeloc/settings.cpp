#include "core/treeloc/settings.hpp"

#include "core/treeloc/verify_scenes.hpp"

namespace stemwise::treeloc {
namespace {

void append(Fields& all, Fields more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

const char* to_string(Method method) {
  switch (method) {
    case Method::stemwise:
      return "stemwise";
    case Method::treelocpp:
      return "treeloc++";
    case Method::treeloc:
      return "treeloc";
  }
  return "";
}

std::optional<Method> method_from(const std::string& word) {
  for (const Method m : {Method::stemwise, Method::treelocpp, Method::treeloc}) {
    if (word == to_string(m)) return m;
  }
  return std::nullopt;
}

double acceptance_score(Method method) { return method == Method::stemwise ? stemwise_acceptance_score : 0.2; }

Issues Settings::check() {
  Issues issues;
  const auto need = [&issues](bool good, const char* key, const char* text) {
    if (!good) issues.push_back({Severity::error, "", 0, key, text, ""});
  };
  need(scene.local_radius_m > 0.0 && scene.local_radius_m <= 300.0, "scene.local_radius_m", "must be above 0 and at most 300 m");
  need(triangles.neighbours >= 2 && triangles.neighbours <= 60, "triangles.neighbours", "must be 2 to 60");
  need(triangles.step_m >= 0.02 && triangles.max_side_m / triangles.step_m <= 1000.0, "triangles.step_m",
       "must be at least 0.02 m and 1/1000 of the longest side");
  need(triangles.min_side_m >= 0.0 && triangles.max_side_m > triangles.min_side_m, "triangles.max_side_m",
       "must be above triangles.min_side_m");
  need(vote.verified >= 1, "vote.verified", "must be at least 1");
  need(vote.gate_m > 0.0 && vote.gate_m < 150.0, "vote.gate_m", "must be above 0 and below 150 m");
  need(match.fine_m > 0.0 && match.coarse_m >= match.fine_m, "match.coarse_m",
       "must be at least match.fine_m, which must be above 0");
  need(match.steps >= 1, "match.steps", "must be at least 1");
  need(tdh.radial_bins >= 1 && tdh.dbh_bins >= 1, "tdh.radial_bins", "there must be a bin");
  need(pdh.bins >= 1 && pdh.longest_m > 0.0, "pdh.bins", "there must be a bin");
  need(retrieve.verified >= 1 && retrieve.kept_by_histograms >= 1, "retrieve.verified", "must be at least 1");
  need(outliers.yaw_bin_deg >= 0.1 && outliers.yaw_bin_deg <= 180.0, "outliers.yaw_bin_deg", "must be 0.1 to 180 degrees");
  need(vertical.sample >= 3 && vertical.trials >= 1, "vertical.sample", "must be at least 3");
  need(overlap.sigma_t_m > 0.0, "overlap.sigma_t_m", "must be above 0");
  need(covariance.inflation > 0.0, "covariance.inflation", "must be above 0");
  need(covariance.scenes_per_independent >= 1.0, "covariance.scenes_per_independent", "must be at least 1");
  return issues;
}

Fields Settings::fields() {
  Fields all;
  append(all, scene.fields("scene"));
  append(all, axes.fields("axes"));
  append(all, triangles.fields("triangles"));
  append(all, vote.fields("vote"));
  append(all, match.fields("match"));
  append(all, verify.fields("verify"));
  append(all, refine.fields("refine"));
  append(all, fuse.fields("fuse"));
  append(all, covariance.fields("covariance"));
  append(all, tdh.fields("tdh"));
  append(all, pdh.fields("pdh"));
  append(all, retrieve.fields("retrieve"));
  append(all, outliers.fields("outliers"));
  append(all, planar.fields("planar"));
  append(all, roll_pitch.fields("roll_pitch"));
  append(all, vertical.fields("vertical"));
  append(all, overlap.fields("overlap"));
  return all;
}

namespace {

/// The published presets (method.md, sections 2 and 4).
void use_plot(Settings& s) {
  s.scene.min_reconstructed = 15;
  s.scene.search_radius_m = 5.0;
  s.scene.dedup_radius_m = 0.4;
  s.triangles.neighbours = 10;
  s.triangles.min_side_m = 1.0;
  s.triangles.step_m = 0.1;
}

void use_route(Settings& s) {
  s.scene.min_reconstructed = 10;
  s.scene.search_radius_m = 10.0;
  s.scene.dedup_radius_m = 0.1;
  s.triangles.neighbours = 15;
  s.triangles.min_side_m = 0.5;
  s.triangles.step_m = 0.15;
}

/// What TreeLoc had before TreeLoc++ (method.md, the paper's appendix G).
void use_predecessor(Settings& s) {
  s.scene.preceding_frames = 0;
  s.pdh.enabled = false;
  s.retrieve.multiset = false;
  s.outliers.yaw_voting = false;
  s.planar.irls = false;
  s.vertical.joint = false;
  s.overlap.penalty = false;
}

}  // namespace

Settings settings_for(Method method, const std::string& preset) {
  Settings s;
  s.method = method;
  if (method == Method::stemwise && preset == "auto") return s;
  s.triangles.area = method != Method::stemwise;
  s.triangles.orientation = method == Method::stemwise;
  if (method != Method::stemwise) s.axes.min_clusters = 3, s.axes.refinements = 0;
  (preset == "route" ? use_route : use_plot)(s);
  if (method == Method::treeloc) use_predecessor(s);
  return s;
}

}  // namespace stemwise::treeloc
