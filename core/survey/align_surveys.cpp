#include "core/survey/align_surveys.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/forest/time_order.hpp"
#include "core/survey/align_lists.hpp"
#include "core/survey/associate_surveys.hpp"
#include "core/survey/level_by_axes.hpp"
#include "core/survey/merge_coincident.hpp"
#include "core/survey/place_survey.hpp"
#include "core/survey/pose_from_frames.hpp"
#include "core/survey/search_stems.hpp"

namespace stemwise {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

constexpr int joint_rounds = 3;

/// An inventory made ready: upright, merged, indexed.
struct Prepared {
  const Inventory* inventory = nullptr;
  RigidTransform level_from_inventory;  ///< turns about the list's own middle
  bool levelled = false;
  IndexedList list;
  std::vector<double> node_height_m;    ///< of each node, upright; NaN where unknown
};

bool is_aligned(const InventoryAlignment& report) { return report.status == AlignmentStatus::reference || report.status == AlignmentStatus::aligned; }

/// Nodes of the stems that the search looks at; their members are indices into the inventory.
NodeList nodes_for_search(const Inventory& inventory, const std::vector<Stem>& stems, const AlignSettings& settings, const AlignHints& hints) {
  constexpr std::size_t most = 5000;
  std::vector<std::size_t> named;
  for (const auto& pair : hints.same_tree)
    for (const StemRef& stem : {pair.a, pair.b})
      if (stem.inventory == inventory.id && stem.index >= 0 && static_cast<std::size_t>(stem.index) < stems.size()) named.push_back(static_cast<std::size_t>(stem.index));
  const std::vector<std::size_t> chosen = search_stems(inventory, most, named);
  std::vector<Stem> few;
  for (const std::size_t i : chosen) few.push_back(stems[i]);
  NodeList nodes = merge_coincident(few, settings.lists.merge_radius_m);
  for (auto& members : nodes.members)
    for (std::size_t& m : members) m = chosen[m];
  return nodes;
}

Prepared prepare(const Inventory& inventory, const AlignSettings& settings, const AlignHints& hints) {
  RigidTransform level;
  const bool heights = std::any_of(inventory.stems.begin(), inventory.stems.end(), [](const Stem& s) { return s.z_m.has_value(); });
  const Levelling levelling = heights ? level_by_axes(inventory.stems, settings.level) : Levelling{};
  if (levelling.observed) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Stem& s : inventory.stems) middle += Eigen::Vector3d(s.x_m, s.y_m, s.z_m.value_or(0.0)) / static_cast<double>(inventory.stems.size());
    level.rotation = levelling.level_from_survey;
    level.translation_m = middle - level.rotation * middle;
  }
  const auto stems = levelling.observed ? moved_stems(inventory, level) : inventory.stems;
  Prepared prepared{&inventory, level, levelling.observed, IndexedList(nodes_for_search(inventory, stems, settings, hints)), {}};
  for (const auto& members : prepared.list.nodes.members)
    prepared.node_height_m.push_back(stems[members.front()].z_m.value_or(std::numeric_limits<double>::quiet_NaN()));
  return prepared;
}

/// How much higher the ground of `on` is than that of `k` where the pose joins their stems (median); 0 when unknown. Undoing
/// a lean turns heights into places: metres of height must be right before.
double height_step_m(const Prepared& on, const Prepared& k, const PlanarPose& on_from_k) {
  constexpr double joined_m = 1.0;
  std::vector<double> steps;
  for (std::size_t i = 0; i < k.list.size(); ++i) {
    const Eigen::Vector2d at = on_from_k * (k.list.nodes.at_m[i] + k.list.nodes.origin_m) - on.list.nodes.origin_m;
    on.list.index.within(at, joined_m, [&](std::size_t j, double) {
      if (const double step = on.node_height_m[j] - k.node_height_m[i]; std::isfinite(step)) steps.push_back(step);
    });
  }
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// All that a run carries from step to step.
class Run {
 public:
  Run(std::span<const Inventory* const> inventories, InventoryId reference, const AlignSettings& settings, const AlignHints& hints)
      : inventories_(inventories), settings_(settings), hints_(hints) {
    reference_ = inventories.size();
    for (std::size_t k = 0; k < inventories.size(); ++k)
      if (inventories[k]->id == reference) reference_ = k;
    if (reference_ < inventories.size()) return;
    reference_ = 0;
    for (std::size_t k = 1; k < inventories.size(); ++k)
      if (inventories[k]->stems.size() > inventories[reference_]->stems.size()) reference_ = k;
  }

  SurveyAlignment work(const Progress& progress) {
    const auto start = Clock::now();
    describe(progress.stage(0.0, 0.05));
    search(progress.stage(0.05, 0.8));
    const auto joint = Clock::now();
    estimate_jointly(progress.stage(0.8, 0.9));
    result_.timing.optimise_s = seconds_since(joint);
    const auto matching = Clock::now();
    match(progress.stage(0.9, 1.0));
    result_.timing.match_s = seconds_since(matching);
    result_.timing.total_s = seconds_since(start);
    return std::move(result_);
  }

 private:
  void describe(const Progress& progress) {
    const auto start = Clock::now();
    result_.reference = inventories_[reference_]->id;
    for (std::size_t k = 0; k < inventories_.size(); ++k) {
      progress.at(static_cast<double>(k) / static_cast<double>(inventories_.size()), "Preparing " + inventories_[k]->name);
      prepared_.push_back(prepare(*inventories_[k], settings_, hints_));
      InventoryAlignment report;
      report.inventory = inventories_[k]->id;
      result_.inventories.push_back(report);
    }
    InventoryAlignment& report = result_.inventories[reference_];
    report.status = AlignmentStatus::reference;
    report.overlap = 1.0;
    const auto& stems = inventories_[reference_]->stems;
    reference_has_heights_ = std::any_of(stems.begin(), stems.end(), [](const Stem& s) { return s.z_m.has_value(); });
    for (const Dof dof : {Dof::x, Dof::y, Dof::yaw}) report.observed.set(dof);
    for (const Dof dof : {Dof::z, Dof::roll, Dof::pitch}) report.observed.set(dof, reference_has_heights_);
    fixed_.assign(inventories_.size(), 0);
    for (std::size_t k = 0; k < inventories_.size(); ++k)
      for (const InventoryAlignment& pose : hints_.base.poses)
        if (pose.inventory == inventories_[k]->id) result_.inventories[k] = pose, fixed_[k] = 1;
    partner_.assign(inventories_.size(), reference_);
    result_.timing.describe_s = seconds_since(start);
  }

  bool is_fixed(InventoryId id) const {
    return std::any_of(hints_.base.poses.begin(), hints_.base.poses.end(), [&](const InventoryAlignment& pose) { return pose.inventory == id; });
  }

  std::optional<double> years(std::size_t from, std::size_t to) const {
    if (!inventories_[from]->date || !inventories_[to]->date) return std::nullopt;
    return years_between(*inventories_[from]->date, *inventories_[to]->date);
  }

  /// Hints for laying inventory k onto inventory `on`, whose pose is known.
  ListHints hints_for(std::size_t k, std::size_t on) const {
    ListHints hints;
    hints.years = years(k, on);
    for (const auto& pair : hints_.same_tree) {
      const bool forth = pair.a.inventory == inventories_[k]->id && pair.b.inventory == inventories_[on]->id;
      const bool back = pair.b.inventory == inventories_[k]->id && pair.a.inventory == inventories_[on]->id;
      if (!forth && !back) continue;
      hints.pairs_ask |= !pair.decided;
      hints.same_tree.emplace_back(static_cast<std::size_t>(forth ? pair.a.index : pair.b.index), static_cast<std::size_t>(forth ? pair.b.index : pair.a.index));
    }
    for (const auto& rough : hints_.rough_poses) {
      if (rough.inventory != inventories_[k]->id || on != reference_) continue;
      const RigidTransform on_from_k = prepared_[on].level_from_inventory * RigidTransform::planar(rough.x_m, rough.y_m, rough.yaw_rad) * prepared_[k].level_from_inventory.inverse();
      const Eigen::Vector3d about_m = prepared_[k].level_from_inventory * Eigen::Vector3d(rough.about_m.x(), rough.about_m.y(), 0.0);
      hints.rough_pose = PoseWindow{planar_part(on_from_k), about_m.head<2>(), rough.radius_m, rough.yaw_radius_rad, rough.same_stand, rough.accepted};
    }
    return hints;
  }

  void name_contradicted(const ListAlignment& found, std::size_t k, std::size_t on) {
    const auto stem = [&](std::size_t inventory, std::size_t index) { return inventories_[inventory]->name + " " + inventories_[inventory]->stems[index].source_id; };
    for (const auto& [in_k, in_on] : found.contradicted)
      result_.notes.push_back(inventories_[k]->name + ": " + stem(on, in_on) + " and " + stem(k, in_k) +
                              " are named as the same tree, but everything else lays them metres apart: look at this pair.");
  }

  /// Lays inventory k onto inventory `on` and takes the pose over when it is accepted, or better than what there was.
  void align_pair(std::size_t k, std::size_t on, const Progress& progress) {
    const auto retrieving = Clock::now();
    const FramePose scenes = pose_from_frames(*inventories_[on], *inventories_[k], settings_.scenes, settings_.joint, settings_.threads, progress.stage(0.0, 0.5));
    result_.timing.retrieve_s += seconds_since(retrieving);
    const auto start = Clock::now();
    ListHints hints = hints_for(k, on);
    if (scenes.a_from_b)
      hints.proposals.push_back(planar_part(prepared_[on].level_from_inventory * *scenes.a_from_b * prepared_[k].level_from_inventory.inverse()));
    const ListAlignment found = align_lists(prepared_[k].list, prepared_[on].list, hints, settings_.lists, settings_.threads, progress.stage(0.5, 1.0));
    result_.timing.verify_s += seconds_since(start);
    name_contradicted(found, k, on);
    InventoryAlignment& report = result_.inventories[k];
    const bool accepted = found.status == AlignmentStatus::aligned || (settings_.accept_probable && found.status == AlignmentStatus::probable);
    const bool better = report.status == AlignmentStatus::unaligned || (report.status == AlignmentStatus::failed && found.status == AlignmentStatus::probable);
    PairReport pair{inventories_[on]->id, inventories_[k]->id, scenes.constraints, accepted ? scenes.accepted : 0};
    if (scenes.constraints == 0) pair = {pair.a, pair.b, found.score.matched > 0 ? 1 : 0, found.status == AlignmentStatus::aligned ? 1 : 0};
    result_.pairs.push_back(pair);
    if (!accepted && !better) return;
    const RigidTransform reference_from_on = result_.inventories[on].reference_from_inventory;
    const auto in_reference = [&](const PlanarPose& on_from_k) {
      RigidTransform upright = on_from_k.rigid();
      if (prepared_[on].levelled || prepared_[k].levelled) upright.translation_m.z() = height_step_m(prepared_[on], prepared_[k], on_from_k);
      return reference_from_on * (prepared_[on].level_from_inventory.inverse() * (upright * prepared_[k].level_from_inventory));
    };
    report.status = accepted ? AlignmentStatus::aligned : found.status;
    report.reason = accepted ? "" : found.reason;
    report.acceptance = found.acceptance;
    report.position_noise_m = found.noise_m;
    report.second_best_pose = found.second_best ? std::optional(in_reference(*found.second_best)) : std::nullopt;
    report.reference_from_inventory = found.score.matched > 0 ? in_reference(found.b_from_a) : RigidTransform{};
    partner_[k] = on;
    for (const Dof dof : {Dof::x, Dof::y, Dof::yaw}) report.observed.set(dof, accepted);
  }

  /// Against the reference first; what is refused there, against those already aligned, the nearest in time first, until
  /// nothing more can be aligned.
  void search(const Progress& progress) {
    const std::size_t count = inventories_.size();
    std::set<std::pair<std::size_t, std::size_t>> tried;
    const double all = static_cast<double>(std::max<std::size_t>(1, count - 1));
    double done = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      if (k == reference_ || fixed_[k] != 0) continue;
      align_pair(k, reference_, progress_of(k, progress.stage(done / all, (done + 1.0) / all)));
      tried.insert({k, reference_});
      done += 1.0;
    }
    for (bool again = true; again;) {
      again = false;
      for (std::size_t k = 0; k < count; ++k) {
        if (is_aligned(result_.inventories[k])) continue;
        for (const std::size_t on : others_by_time(k)) {
          if (is_aligned(result_.inventories[k])) break;
          if (!is_aligned(result_.inventories[on]) || !tried.insert({k, on}).second) continue;
          align_pair(k, on, progress_of(k, progress.stage(1.0, 1.0)));
          again = again || is_aligned(result_.inventories[k]);
        }
      }
    }
  }

  /// Puts the inventory's name before what the search says.
  Progress progress_of(std::size_t k, const Progress& progress) const { return progress.prefixed("Aligning " + inventories_[k]->name + ": "); }

  std::vector<std::size_t> others_by_time(std::size_t k) const {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t on = 0; on < inventories_.size(); ++on)
      if (on != k) order.emplace_back(std::abs(years(k, on).value_or(std::abs(static_cast<double>(k) - static_cast<double>(on)))), on);
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> result;
    for (const auto& entry : order) result.push_back(entry.second);
    return result;
  }

  /// Aligned inventories in the order of time.
  std::vector<std::size_t> aligned_by_time() const {
    std::vector<std::optional<Date>> dates;
    for (const Inventory* inventory : inventories_) dates.push_back(inventory->date);
    std::vector<std::size_t> order = time_order(dates);
    std::erase_if(order, [&](std::size_t k) { return !is_aligned(result_.inventories[k]); });
    return order;
  }

  std::vector<PlacedSurvey> placed(const std::vector<std::size_t>& order) const {
    std::vector<PlacedSurvey> surveys;
    double noise_m = settings_.lists.noise_floor_m;
    for (const std::size_t k : order) noise_m = std::max(noise_m, result_.inventories[k].position_noise_m);
    for (const std::size_t k : order) {
      const InventoryAlignment& report = result_.inventories[k];
      const double own_m = k == reference_ ? noise_m : std::max(settings_.lists.noise_floor_m, report.position_noise_m);
      surveys.push_back(place_survey(*inventories_[k], report.reference_from_inventory, prepared_[reference_].list.nodes.origin_m, own_m));
    }
    return surveys;
  }

  /// The tree as the other surveys have it: mean place, height and axis in the reference's frame.
  Stem consensus(const SightedTree& tree, std::size_t without, const std::vector<std::size_t>& order, const std::vector<PlacedSurvey>& surveys) const {
    Stem mean;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    double height_m = 0.0;
    int count = 0, heights = 0;
    for (const StemSighting& s : tree) {
      if (s.survey == without) continue;
      const RigidTransform& to_reference = result_.inventories[order[s.survey]].reference_from_inventory;
      const Stem& stem = surveys[s.survey].inventory->stems[surveys[s.survey].stem_of[s.node]];
      const Eigen::Vector3d p = to_reference * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
      mean.x_m += p.x(), mean.y_m += p.y(), ++count;
      if (!reference_has_heights_) continue;  // without them nobody can say how high, or how level, the others lie on it
      if (stem.z_m) height_m += p.z(), ++heights;
      if (stem.axis) axis += to_reference.rotation * (stem.axis->z() < 0.0 ? Eigen::Vector3d(-*stem.axis) : *stem.axis);
    }
    mean.x_m /= count, mean.y_m /= count;
    if (heights > 0) mean.z_m = height_m / heights;
    if (axis.norm() > 0.0) mean.axis = axis.normalized();
    return mean;
  }

  /// Poses and trees in turn: every survey is laid onto the mean of the others' stems (robust, all six degrees of freedom
  /// where heights and axes allow); the reference stays where it is.
  void estimate_jointly(const Progress& progress) {
    const auto order = aligned_by_time();
    if (order.size() < 2) return;
    progress.at(0.0, "Estimating all poses together");
    std::vector<PlacedSurvey> surveys = placed(order);
    const auto trees = associate_surveys(surveys, hints_, settings_.lists.noise_floor_m, progress.stage(0.0, 0.5));
    const int rounds = order.size() > 2 ? joint_rounds : 1;
    for (int round = 0; round < rounds; ++round)
      for (std::size_t s = 0; s < order.size(); ++s) {
        progress.check();
        if (order[s] != reference_ && fixed_[order[s]] == 0) refit(s, order, surveys, trees, round + 1 == rounds);
      }
  }

  void refit(std::size_t survey, const std::vector<std::size_t>& order, const std::vector<PlacedSurvey>& surveys, const std::vector<SightedTree>& trees, bool last) {
    std::vector<Stem> consensus_stems;
    std::vector<IndexPair> pairs;
    for (const SightedTree& tree : trees) {
      const auto own = std::find_if(tree.begin(), tree.end(), [&](const StemSighting& s) { return s.survey == survey; });
      if (own == tree.end() || tree.size() < 2) continue;
      pairs.push_back({consensus_stems.size(), surveys[survey].stem_of[own->node]});
      consensus_stems.push_back(consensus(tree, survey, order, surveys));
    }
    InventoryAlignment& report = result_.inventories[order[survey]];
    const SixDofReport fit = refine_six_dof(consensus_stems, surveys[survey].inventory->stems, pairs, report.reference_from_inventory, settings_.six_dof);
    if (pairs.size() < 3) return;
    report.reference_from_inventory = fit.reference_from_query;
    report.observed = fit.observed;
    if (!last) return;
    for (const std::string& note : fit.notes) result_.notes.push_back(surveys[survey].inventory->name + ": " + note);
  }

  void match(const Progress& progress) {
    const auto order = aligned_by_time();
    if (order.size() < 2) return;
    const auto surveys = placed(order);
    const auto trees = associate_surveys(surveys, hints_, settings_.lists.noise_floor_m, progress);
    result_.matches = consecutive_matches(surveys, trees);
    std::erase_if(result_.matches, [&](const Match& m) { return is_fixed(m.a.inventory) && is_fixed(m.b.inventory); });
    for (std::size_t s = 0; s < order.size(); ++s)
      if (fixed_[order[s]] == 0) describe_fit(s, order, surveys, trees);
  }

  /// Overlap, residual and noise of one survey against the one that it was laid onto.
  void describe_fit(std::size_t survey, const std::vector<std::size_t>& order, const std::vector<PlacedSurvey>& surveys, const std::vector<SightedTree>& trees) {
    InventoryAlignment& report = result_.inventories[order[survey]];
    const auto partner = static_cast<std::size_t>(std::find(order.begin(), order.end(), partner_[order[survey]]) - order.begin());
    if (partner == order.size()) return;
    std::vector<double> distance_sq;
    int sighted = 0;
    for (const SightedTree& tree : trees) {
      const StemSighting *own = nullptr, *other = nullptr;
      for (const StemSighting& s : tree) {
        if (s.survey == survey) own = &s;
        if (s.survey == partner) other = &s;
      }
      if (own != nullptr && tree.size() > 1) ++sighted;
      if (own != nullptr && other != nullptr)
        distance_sq.push_back((surveys[survey].list.nodes.at_m[own->node] - surveys[partner].list.nodes.at_m[other->node]).squaredNorm());
    }
    report.matched = survey == partner ? sighted : static_cast<int>(distance_sq.size());
    if (survey == partner || distance_sq.empty()) return;
    double sum_sq = 0.0;
    for (const double d : distance_sq) sum_sq += d;
    report.residual_rms_m = std::sqrt(sum_sq / static_cast<double>(distance_sq.size()));
    std::nth_element(distance_sq.begin(), distance_sq.begin() + static_cast<std::ptrdiff_t>(distance_sq.size() / 2), distance_sq.end());
    report.position_noise_m = std::sqrt(distance_sq[distance_sq.size() / 2] / 1.386);  // the median of r^2 is 2 ln 2 sigma^2
    const auto inside = [&](std::size_t of, std::size_t in) {
      const auto& places = surveys[of].list.nodes.at_m;
      return std::count_if(places.begin(), places.end(), [&](const Eigen::Vector2d& p) { return surveys[in].list.support.contains(p); });
    };
    const auto together = static_cast<double>(inside(survey, partner) + inside(partner, survey) - report.matched);
    report.overlap = std::clamp(report.matched / std::max(1.0, together), 0.0, 1.0);
  }

  std::span<const Inventory* const> inventories_;
  const AlignSettings& settings_;
  const AlignHints& hints_;
  std::size_t reference_ = 0;
  bool reference_has_heights_ = false;
  std::vector<Prepared> prepared_;
  std::vector<std::uint8_t> fixed_;   ///< of the base
  std::vector<std::size_t> partner_;  ///< per inventory: the one that it was laid onto
  SurveyAlignment result_;
};

}  // namespace

Fields AlignSettings::fields() {
  Fields all{{"align.preset", "", "TreeLoc++ parameters for frames: auto, plot or route.", &preset},
             {"align.accept_probable", "", "Takes probable poses as accepted ones.", &accept_probable}};
  for (auto part : {lists.fields(), level.fields(), six_dof.fields(), scenes.fields("scenes"), joint.fields()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

SurveyAlignment align_surveys(std::span<const Inventory* const> inventories, InventoryId reference, const AlignSettings& settings, const AlignHints& hints,
                              const Progress& progress) {
  if (inventories.empty()) return {};
  return Run(inventories, reference, settings, hints).work(progress);
}

}  // namespace stemwise
