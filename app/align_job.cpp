#include "app/align_job.hpp"

#include <algorithm>
#include <array>

#include "app/rough_poses.hpp"
#include "app/with_frames.hpp"
#include "core/project/commands.hpp"
#include "core/survey/coverage.hpp"
#include "core/survey/crs_offsets.hpp"

namespace stemwise {
namespace {

using Surveys = std::vector<std::shared_ptr<const Inventory>>;

void add_decisions(const ProjectState& state, AlignHints& hints) {
  for (const AlignHints::RoughPose& rough : rough_poses(state)) {
    const auto is_of_it = [&](const AlignHints::RoughPose& given) { return given.inventory == rough.inventory; };
    if (std::none_of(hints.rough_poses.begin(), hints.rough_poses.end(), is_of_it)) hints.rough_poses.push_back(rough);
  }
  for (const auto& [pair, match] : state.matches) {
    if (match.state == MatchState::automatic) continue;
    (match.joins() ? hints.same_tree : hints.not_same).push_back({pair.first, pair.second, true});
  }
}

AlignBase base_of(const ProjectState& state) {
  AlignBase base;
  for (const auto& [id, alignment] : state.alignments)
    if (state.is_placed(id)) base.poses.push_back(alignment);
  for (const auto& [id, tree] : state.trees) base.trees.push_back(tree.stems);
  return base;
}

/// What the base had, put back in front of what was found.
void keep_base(const ProjectState& state, SurveyAlignment& result) {
  std::vector<PairReport> pairs = state.pairs;
  pairs.insert(pairs.end(), result.pairs.begin(), result.pairs.end());
  result.pairs = std::move(pairs);
  for (const auto& [key, match] : state.matches)
    if (match.state == MatchState::automatic && state.is_placed(match.a.inventory) && state.is_placed(match.b.inventory)) result.matches.push_back(match);
}

Surveys surveys_with_frames(const ProjectState& state, int threads, std::vector<std::string>& notes, const Progress& progress) {
  Surveys surveys;
  for (const auto& inventory : state.inventories) {
    progress.at(0.0, "Reading " + inventory->name);
    surveys.push_back(with_frames(inventory, threads, notes));
  }
  return surveys;
}

bool is_decided(InventoryId id, const ProjectState& state, const AlignHints& hints) {
  const auto touches = [&](const AlignHints::SameTree& pair) { return pair.a.inventory == id || pair.b.inventory == id; };
  const auto by_hand = [&](const auto& entry) {
    const TreeRecord& tree = entry.second;
    const bool spoken_of = tree.fate_by_hand || !tree.note.empty();
    return spoken_of && std::any_of(tree.stems.begin(), tree.stems.end(), [&](const StemRef& stem) { return stem.inventory == id; });
  };
  return std::any_of(hints.same_tree.begin(), hints.same_tree.end(), touches) || std::any_of(hints.not_same.begin(), hints.not_same.end(), touches) ||
         std::any_of(state.trees.begin(), state.trees.end(), by_hand);
}

/// Stems are made anew only where nothing was said about them yet.
std::vector<bool> free_to_correct(const ProjectState& state, const AlignHints& hints) {
  std::vector<bool> free;
  for (const auto& inventory : state.inventories) {
    const bool has_place = !state.alignments.empty() && state.is_placed(inventory->id);
    free.push_back(inventory->frames && !has_place && !is_decided(inventory->id, state, hints));
  }
  return free;
}

std::vector<RejectedConstraint> rejected_of(const RegisterReport& report, const Surveys& surveys) {
  std::vector<RejectedConstraint> rejected;
  for (const TrajectoryConstraint& c : report.constraints)
    if (!c.accepted) rejected.push_back({surveys[c.a]->id, surveys[c.b]->id, c.frame_a, c.frame_b, c.residual_m});
  std::stable_sort(rejected.begin(), rejected.end(), [](const auto& p, const auto& q) { return p.residual_m > q.residual_m; });
  return rejected;
}

/// Drift taken out of `surveys`; the notes are the report's.
void correct(const ProjectState& state, Surveys& surveys, const AlignJobSettings& settings, const AlignHints& hints, std::vector<std::string>& notes, AlignOutcome& outcome,
             const Progress& progress) {
  RegisterSettings registering = settings.registering;
  registering.scenes = settings.align.scenes;
  registering.lists = settings.align.lists;
  const Registered registered = correct_trajectories(surveys, free_to_correct(state, hints), registering, settings.align.threads, progress);
  notes.insert(notes.end(), registered.report.notes.begin(), registered.report.notes.end());
  outcome.rejected = rejected_of(registered.report, surveys);
  for (std::size_t s = 0; s < surveys.size(); ++s)
    if (registered.corrected[s]) outcome.corrected.push_back(surveys[s] = registered.corrected[s]);
}

/// Of inventories in one coordinate system the pose is near the identity: what GNSS and a compass are off by.
bool add_crs_priors(const ProjectState& state, const SurveyAlignment& tried, AlignHints& hints) {
  const std::size_t given = hints.rough_poses.size();
  for (const InventoryAlignment& a : tried.inventories) {
    if (a.status != AlignmentStatus::failed && a.status != AlignmentStatus::probable) continue;
    const Inventory& inventory = *state.find(a.inventory);
    AlignHints::RoughPose prior;
    prior.inventory = a.inventory;
    prior.same_stand = true;
    for (const Stem& stem : inventory.stems) prior.about_m += Eigen::Vector2d(stem.x_m, stem.y_m) / static_cast<double>(inventory.stems.size());
    hints.rough_poses.push_back(prior);
  }
  return hints.rough_poses.size() > given;
}

/// By --crs, or since every file says the same one.
bool share_crs(const std::vector<const Inventory*>& inventories, const AlignJobSettings& settings) {
  if (settings.one_crs) return true;
  return std::all_of(inventories.begin(), inventories.end(), [&](const Inventory* i) { return i->source.epsg && i->source.epsg == inventories.front()->source.epsg; });
}

}  // namespace

Fields AlignJobSettings::fields() {
  Fields all = align.fields();
  for (const Field& field : registering.fields()) all.push_back(field);
  return all;
}

Issues AlignJobSettings::check() {
  constexpr std::array above_zero = {"lists.cell_m", "lists.middle_cell_m", "lists.coarse_cell_m", "lists.whole_list_stems", "lists.scenes", "lists.scene_stems", "lists.peaks", "lists.noise_floor_m",
                                     "six_dof.planar_floor_m", "six_dof.height_floor_m", "six_dof.axis_floor_deg", "six_dof.rounds", "joint.agreement_m", "joint.lever_m", "joint.noise_m",
                                     "scenes.most_queries", "scenes.grid_spacing_m", "register.window_m", "register.window_step_m", "register.odometry_share"};
  constexpr std::array cells = {"lists.cell_m", "lists.middle_cell_m", "lists.coarse_cell_m"};
  Issues issues;
  const auto refuse = [&issues](const std::string& key, const char* text) { issues.push_back({Severity::error, "", 0, key, text, ""}); };
  const auto is_in = [](const auto& list, const std::string& key) { return std::find(list.begin(), list.end(), key) != list.end(); };
  for (const Field& field : fields()) {
    const auto* const* real = std::get_if<double*>(&field.value);
    const auto* const* whole = std::get_if<int*>(&field.value);
    if (real == nullptr && whole == nullptr) continue;
    const double value = real != nullptr ? **real : static_cast<double>(**whole);
    if (is_in(cells, field.key) && !(value >= 0.05 && value <= 100.0)) refuse(field.key, "must be between 0.05 and 100 m");
    else if (is_in(above_zero, field.key) && !(value > 0.0)) refuse(field.key, "must be above 0");
    else if (!(value >= 0.0)) refuse(field.key, "must not be negative");
  }
  if (const std::string& preset = align.preset; preset != "auto" && preset != "plot" && preset != "route") refuse("align.preset", "must be auto, plot or route");
  return issues;
}

AlignOutcome align_project(const ProjectState& state, const AlignJobSettings& settings, AlignHints hints, const Progress& progress) {
  add_decisions(state, hints);
  std::vector<std::string> notes;
  Surveys surveys = surveys_with_frames(state, settings.align.threads, notes, progress);
  AlignOutcome outcome;
  correct(state, surveys, settings, hints, notes, outcome, progress.stage(0.0, 0.2));
  std::vector<const Inventory*> inventories;
  for (const auto& survey : surveys) inventories.push_back(survey.get());
  outcome.alignment = align_surveys(inventories, state.reference, settings.align, hints, progress.stage(0.2, settings.one_crs ? 0.6 : 1.0));
  if (settings.one_crs && add_crs_priors(state, outcome.alignment, hints))
    outcome.alignment = align_surveys(inventories, state.reference, settings.align, hints, progress.stage(0.6, 1.0));
  outcome.alignment.notes.insert(outcome.alignment.notes.begin(), notes.begin(), notes.end());
  if (share_crs(inventories, settings))
    for (std::string& warning : crs_warnings(inventories, outcome.alignment)) outcome.alignment.notes.push_back(std::move(warning));
  progress.check();
  std::vector<Coverage> coverages = estimate_coverages(inventories, outcome.alignment);
  for (std::size_t i = 0; i < inventories.size(); ++i) outcome.coverages.emplace_back(inventories[i]->id, std::move(coverages[i]));
  return outcome;
}

AlignOutcome align_added(const ProjectState& state, const AlignJobSettings& settings, AlignHints hints, const Progress& progress) {
  hints.base = base_of(state);
  AlignOutcome outcome = align_project(state, settings, std::move(hints), progress);
  keep_base(state, outcome.alignment);
  std::erase_if(outcome.coverages, [&](const auto& entry) { return state.coverages.contains(entry.first); });
  return outcome;
}

CommandPtr apply_outcome(AlignOutcome outcome) {
  CommandPtr alignment = apply_alignment(std::move(outcome.alignment), std::move(outcome.coverages));
  if (outcome.corrected.empty()) return alignment;
  std::string label = alignment->label();
  std::vector<CommandPtr> commands;
  for (auto& inventory : outcome.corrected) commands.push_back(replace_inventory(std::move(inventory)));
  commands.push_back(std::move(alignment));
  return group(std::move(label), std::move(commands));
}

}  // namespace stemwise
