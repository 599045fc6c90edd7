#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/survey/fusion_review.hpp"
#include "core/survey/growth_groups.hpp"
#include "core/survey/rule_pack.hpp"
#include "core/survey/stand_change.hpp"
#include "core/survey/stand_growth.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {

// The growth report as numbers: everything a report of any format shows is here, counted once. Lengths in metres unless
// the name says otherwise. Surveys are indices into ReportModel::surveys, by date.

struct ReportOptions {
  std::optional<double> area_ha;      ///< given by a person; without it each survey's own coverage is the area
  double dbh_class_width_cm = 5.0;    ///< classes [k w, (k+1) w): the lower limit belongs to the class
};

/// Where a per-hectare figure's hectares come from. Nothing where no area is known: then there is no per-hectare figure.
struct ReportArea {
  double ha = 0.0;
  std::string source;  ///< "given", "outline of the stems", "what the frames saw", "drawn"
};

struct ReportSurvey {
  InventoryId id;
  std::string name;
  std::optional<Date> date;
  int stems = 0;
  int stems_with_dbh = 0;
  int dead = 0;                        ///< marked dead in the file: in no stand figure
  int beyond_area = 0;                 ///< living, outside the coverage that was drawn: in no stand figure
  AlignmentStatus status = AlignmentStatus::unaligned;
  std::string reason;
  std::vector<std::string> trajectory_notes;  ///< what was done about its drift
  ObservedDofs observed;
  double overlap = 0.0;
  int matched = 0;
  double residual_rms_m = 0.0;
  double position_noise_m = 0.0;
  double margin = 0.0;
  double probability = 0.0;
  std::optional<double> dbh_error_m;
  std::optional<ReportArea> area;
  double basal_area_sq_m = 0.0;        ///< of the living stems with a DBH
  std::optional<double> mean_dbh_m;
  std::optional<double> quadratic_mean_dbh_m;
  bool placed = false;                 ///< in the common frame, so in every table below
};

/// The change of the stems that two consecutive surveys share.
struct ReportGrowth {
  std::size_t from = 0, to = 0;
  GrowthRow row;
  int grew = 0, shrank = 0, within_error = 0;
  std::vector<double> changes_m;       ///< one per matched stem with two DBHs, ascending
  int survivors = 0, new_stems = 0, missing_stems = 0;
  std::optional<double> basal_area_change_sq_m;  ///< of the matched stems
};

struct ReportDbhClass {
  double low_cm = 0.0, high_cm = 0.0;
  std::vector<int> stems;              ///< per survey
  std::vector<double> basal_area_sq_m; ///< per survey
};

/// One stem that one survey has and the next (or the one before) has not.
struct ReportStem {
  TreeId tree;
  StemRef stem;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  std::optional<double> dbh_m;
  std::string species;
  Fate fate = Fate::unresolved;
  std::size_t survey = 0;
};

/// One rule of a pack, and how many pairs it flags.
struct ReportRule {
  std::string pack;
  RuleCount count;
  bool is_chosen = false;
};

/// A pair of sightings that breaks a rule of the chosen pack.
struct ReportFlagged {
  TreeId tree;
  std::size_t from = 0, to = 0;        ///< surveys
  double earlier_dbh_m = 0.0, later_dbh_m = 0.0;
  std::optional<double> growth_m_per_year;
  std::string flags, species;
};

struct ReportModel {
  std::string title;
  std::string reference;
  std::string georeference;            ///< "" without one
  std::string height_datum;            ///< "the ellipsoid", "the geoid egm2008-5"
  double georeference_sd_m = 0.0;
  std::vector<ControlResidual> georeference_residuals;
  std::optional<double> north_rad;     ///< direction of true north in the reference's frame, counter-clockwise from +x
  std::map<std::string, std::string> settings;
  std::string rule_pack;               ///< "" when none is chosen
  std::vector<ReportRule> rules;       ///< of the chosen pack first, then of the others
  std::vector<ReportFlagged> flagged;  ///< by the chosen pack, the largest change first
  FusionPolicy fusion = FusionPolicy::min_dbh;
  ReportOptions options;
  std::vector<ReportSurvey> surveys;   ///< placed ones by date, then the others
  std::size_t placed = 0;              ///< how many of `surveys` are placed
  std::vector<ReportGrowth> growth;
  std::vector<StandGrowth> stand_growth;  ///< one per step, with intervals
  GrowthGroups growth_groups;          ///< by species and DBH class
  std::vector<StandChange> changes;    ///< components of change, one per step
  std::vector<ReportDbhClass> dbh_classes;
  std::vector<int> without_dbh;        ///< living stems without a DBH, per placed survey
  std::vector<ReportStem> new_stems;   ///< ingrowth and missed earlier, of the survey that saw them first
  std::vector<ReportStem> missing_stems;  ///< missing, dead, removed, of the survey that saw them last
  std::array<int, fate_count> trees_by_fate{};
  std::vector<TreeRow> trees;
  int decisions_by_hand = 0;
  std::vector<FusionConflict> conflicts;
  int chosen_by_hand = 0;              ///< trees with a value whose survey a person chose
  ObservedGround ground;
};

ReportModel make_report_model(const ProjectState& state, const Tables& tables, const ReportOptions& options);

}  // namespace stemwise
