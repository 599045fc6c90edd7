#include "core/treeloc/settings.hpp"

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
  return all;
}

Settings settings_for(Method method, const std::string& preset) {
  Settings s;
  s.method = method;
  (void)preset;
  return s;
}

Settings resolve_settings(const Settings& settings, const FrameSet&) { return settings; }

}  // namespace stemwise::treeloc
