#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/ids.hpp"
#include "core/geometry/rigid_transform.hpp"

namespace stemwise {

/// What became of one inventory. Words of cli.md; `unaligned` is an inventory nobody has tried yet.
enum class AlignmentStatus { unaligned, reference, aligned, probable, failed };
const char* to_string(AlignmentStatus status);
std::optional<AlignmentStatus> alignment_status_from(const std::string& word);

/// The six degrees of freedom in the order in which they are reported.
enum class Dof { x, y, yaw, z, roll, pitch };
struct ObservedDofs {
  std::array<bool, 6> seen{};
  bool operator[](Dof d) const { return seen[static_cast<std::size_t>(d)]; }
  void set(Dof d, bool value = true) { seen[static_cast<std::size_t>(d)] = value; }
  bool operator==(const ObservedDofs&) const = default;
};

/// Why a pose was believed or not: the chance-corrected statistic of stem-lists.md, steps 6 and 7 (natural logarithms).
struct Acceptance {
  double log_likelihood_ratio = 0.0;  ///< Lambda: "the same stand, this pose" against "chance"
  double log_poses_tried = 0.0;       ///< ln N
  double margin = 0.0;                ///< S = Lambda - max(Lambda_2, Lambda_mirror)
  double second_best = 0.0;           ///< Lambda_2
  double mirror = 0.0;                ///< Lambda of the best pose of the mirrored list: what chance can do here
  double probability = 0.0;           ///< 0..1
  bool operator==(const Acceptance&) const = default;
};

/// The report of aligning one inventory to the reference.
struct InventoryAlignment {
  InventoryId inventory;
  AlignmentStatus status = AlignmentStatus::unaligned;
  std::string reason;  ///< why it failed or is only probable, as a sentence for the person; empty when aligned
  RigidTransform reference_from_inventory;  ///< unobserved degrees of freedom are zero; a proposal while `probable`
  ObservedDofs observed;
  double overlap = 0.0;            ///< matched / (union of the stems inside both coverages), 0..1
  double position_noise_m = 0.0;   ///< estimated one-axis standard deviation of the matched stems' planar difference
  Acceptance acceptance;
  int matched = 0;
  double residual_rms_m = 0.0;     ///< planar, over matched stems
  std::optional<RigidTransform> second_best_pose;  ///< reference from inventory
  bool operator==(const InventoryAlignment&) const = default;
};

/// Two inventories against each other, before everything is put together.
struct PairReport {
  InventoryId a;
  InventoryId b;
  int constraints = 0;  ///< relative poses proposed (scenes that met), at least 1 where a pose was found
  int accepted = 0;     ///< of these, in agreement with the joint estimate
  bool operator==(const PairReport&) const = default;
};

enum class MatchState { automatic, accepted, rejected, linked };
const char* to_string(MatchState state);
std::optional<MatchState> match_state_from(const std::string& word);

/// One stem of one survey held to be the same tree as one stem of another. A rejected one is kept as the record that
/// these two must not be joined; the others join.
struct Match {
  StemRef a;
  StemRef b;
  double distance_m = 0.0;       ///< planar, in the common frame
  double confidence = 0.0;       ///< 0..1, from residual, DBH agreement and the margin to the second choice
  MatchState state = MatchState::automatic;
  std::optional<StemRef> second_choice;      ///< the other stem that a (or b) could have been
  std::optional<double> second_distance_m;
  bool joins() const { return state != MatchState::rejected; }
  bool operator==(const Match&) const = default;
};

/// Seconds per stage, in the order of cli.md (read is filled by the caller).
struct AlignTiming {
  double read_s = 0.0, describe_s = 0.0, retrieve_s = 0.0, verify_s = 0.0, optimise_s = 0.0, match_s = 0.0, total_s = 0.0;
};

/// The result of aligning and matching all surveys: what ApplyAlignment takes.
struct SurveyAlignment {
  InventoryId reference;
  std::vector<InventoryAlignment> inventories;  ///< one per inventory, in the order given
  std::vector<PairReport> pairs;
  /// Joined stems; consistent over n surveys: as a graph every connected component has at most one stem per inventory.
  std::vector<Match> matches;
  std::vector<std::string> notes;  ///< what a person should know, one sentence each
  AlignTiming timing;
};

}  // namespace stemwise
