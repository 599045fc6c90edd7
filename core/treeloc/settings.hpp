#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "core/treeloc/step_settings.hpp"

namespace stemwise::treeloc {

enum class Method { stemwise, treelocpp, treeloc };
/// "stemwise", "treeloc++", "treeloc".
const char* to_string(Method method);
std::optional<Method> method_from(const std::string& word);

/// The fixed score from which on a match is accepted, for all forests; each form of the penalty has its own.
double acceptance_score(Method method);

/// Every setting of a method, step by step.
struct Settings {
  Method method = Method::stemwise;
  std::uint64_t seed = 0;  ///< of the published method's RANSAC; the default method has no random choice
  PrepareSettings scene;
  AlignAxesSettings axes;
  CovarianceSettings covariance;
  TriangleSettings triangles;
  // The default method
  VoteSettings vote;
  MatchTreesSettings match;
  VerifySettings verify;
  RefinePoseSettings refine;
  FusePosesSettings fuse;
  // The published method
  TdhSettings tdh;
  PdhSettings pdh;
  RetrieveSettings retrieve;
  RejectOutliersSettings outliers;
  EstimatePlanarPoseSettings planar;
  EstimateRollPitchSettings roll_pitch;
  CorrectVerticalSettings vertical;
  OverlapScoreSettings overlap;

  /// All of them under "scene.", "axes.", ...: what `--set` takes.
  Fields fields();
  Issues check();
};

/// The settings of a method. `preset`: "auto" (the default; one for all sites), "plot" or "route" (the published ones). Of the
/// published methods "auto" is "plot": with its triangles the published figures come out on plots and routes alike
/// (docs/evaluation.md).
Settings settings_for(Method method, const std::string& preset);

}  // namespace stemwise::treeloc
