#include "core/survey/align_lists.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/parallel.hpp"
#include "core/survey/grow_pose.hpp"
#include "core/survey/pose_by_hand.hpp"

namespace stemwise {
namespace {

constexpr double start_sigma_in_cells = 1.3;
constexpr double distinct_pose_m = 2.5;
constexpr std::size_t poses_kept = 12;
constexpr std::size_t poses_grown = 5;         // per scene and DBH model
constexpr double overwhelming = 80.0;          // Lambda - ln N at which no further scene is asked
constexpr std::size_t mirror_scenes_at_least = 2;
constexpr std::size_t mirror_scenes_of_a_refusal = 4;  // enough to tell a mirrored list from another one

struct ScoredPose {
  PoseFit fit;
  PoseScore score;
};

/// One direction of the search: all that stays the same while scenes and DBH models change.
struct Search {
  const IndexedList& a;
  const IndexedList& b;
  const ListSettings& settings;
  VoteSettings vote;
  double convincing = 0.0;       ///< Lambda from which a pose is grown to the whole list whatever it gains
  std::vector<ScoredPose> best;  ///< distinct poses, best first
  int refined = 0;
};

double distinct_m(const ScoredPose& pose) { return std::max(distinct_pose_m, 3.0 * pose.fit.noise_m); }

/// Keeps `found` unless a better pose lies at the same place; throws out what is worse there.
void keep_distinct(std::vector<ScoredPose>& best, const ScoredPose& found) {
  for (const auto& other : best)
    if (other.score.log_likelihood_ratio >= found.score.log_likelihood_ratio &&
        distance_between_m(other.fit.b_from_a, found.fit.b_from_a, other.score) <= distinct_m(other))
      return;
  std::erase_if(best, [&](const ScoredPose& other) {
    return other.score.log_likelihood_ratio < found.score.log_likelihood_ratio &&
           distance_between_m(other.fit.b_from_a, found.fit.b_from_a, found.score) <= distinct_m(found);
  });
  const auto place = std::find_if(best.begin(), best.end(), [&](const ScoredPose& o) { return o.score.log_likelihood_ratio < found.score.log_likelihood_ratio; });
  best.insert(place, found);
  if (best.size() > poses_kept) best.pop_back();
}

ScoredPose fit_in_scene(const Search& s, const Scene& scene, const PlanarPose& pose, const DbhModel& model) {
  PoseFit fit = refine_pose(s.a, scene.nodes, s.b, {pose, start_sigma_in_cells * vote_cell_m(scene, s.b), model, 0.0}, s.settings.noise_floor_m);
  fit.dbh = refit_dbh(s.a, scene.nodes, s.b, fit);
  fit = refine_pose(s.a, scene.nodes, s.b, fit, s.settings.noise_floor_m);
  return {fit, score_pose(s.a, s.b, fit, scene.whole_list ? nullptr : &scene)};
}

/// Votes, refines every peak in its scene, then the best of them on the whole list.
void search_scene(Search& s, const Scene& scene, const DbhModel& model, const Progress& progress) {
  std::vector<PlanarPose> starts;
  for (const PosePeak& peak : vote_poses(s.a, scene, s.b, model, s.vote, progress)) starts.push_back(peak.b_from_a);
  std::vector<ScoredPose> in_scene(starts.size());
  parallel_for(starts.size(), s.vote.threads, [&](std::size_t k) {
    progress.check();
    in_scene[k] = fit_in_scene(s, scene, starts[k], model);
  });
  s.refined += static_cast<int>(starts.size());
  std::vector<ScoredPose> distinct;
  for (const auto& pose : in_scene)
    if (pose.score.matched >= 2) keep_distinct(distinct, pose);
  if (!scene.whole_list) {
    distinct.resize(std::min(distinct.size(), poses_grown));
    parallel_for(distinct.size(), s.vote.threads, [&](std::size_t k) {
      progress.check();
      distinct[k].fit = grow_pose(s.a, scene, s.b, distinct[k].fit, s.settings.noise_floor_m, s.convincing);
      distinct[k].score = score_pose(s.a, s.b, distinct[k].fit, nullptr);
    });
  }
  for (const auto& pose : distinct) keep_distinct(s.best, pose);
}

double best_of(const std::vector<ScoredPose>& best, std::size_t place) {
  return place < best.size() ? std::max(0.0, best[place].score.log_likelihood_ratio) : 0.0;
}

/// ln N: translations of half a metre, yaws that move the rim by half a metre, times scenes and DBH models.
double log_poses_tried(const IndexedList& b, const std::vector<Scene>& scenes, std::size_t bank, const std::optional<PoseWindow>& window) {
  double radius_m = 0.0;
  for (const Scene& scene : scenes) radius_m = std::max(radius_m, scene.radius_m);
  radius_m = std::max(radius_m, 1.0);
  const Eigen::Vector2d size = (b.high_m - b.low_m).array() + 2.0 * radius_m;
  double shifts = size.x() * size.y() / 0.25, yaws = 2.0 * std::numbers::pi * radius_m / 0.5;
  if (window) {
    shifts = std::min(shifts, std::max(1.0, std::numbers::pi * window->radius_m * window->radius_m / 0.25));
    yaws = std::min(yaws, std::max(1.0, 2.0 * window->yaw_radius_rad * radius_m / 0.5));
  }
  return std::log(shifts * yaws * static_cast<double>(scenes.size() * bank));
}

struct SearchPlan {
  std::vector<Scene> scenes;
  std::vector<DbhModel> bank;
  double log_poses = 0.0;
};

/// So far above chance, and above every other pose, that no further scene or model is asked.
bool overwhelming_lead(const std::vector<ScoredPose>& best, double log_poses) {
  const double lead = best_of(best, 0) - best_of(best, 1);
  return best_of(best, 0) - log_poses >= overwhelming && lead >= 0.5 * best_of(best, 0);
}

/// Goes through scenes and models; stops early once a pose is overwhelming. Returns how many scenes were asked.
std::size_t search_all(Search& s, const SearchPlan& plan, std::size_t scene_limit, bool may_stop, const Progress& progress, const std::string& text) {
  const std::size_t count = std::min(scene_limit, plan.scenes.size());
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t m = 0; m < plan.bank.size(); ++m) {
      progress.at(static_cast<double>(k * plan.bank.size() + m) / static_cast<double>(count * plan.bank.size()), text);
      search_scene(s, plan.scenes[k], plan.bank[m], progress);
      if (may_stop && overwhelming_lead(s.best, plan.log_poses)) return k + 1;
    }
  return count;
}

/// Poses from elsewhere are fitted and scored on the whole list. True when one of them is overwhelming.
bool verify_proposals(Search& s, const SearchPlan& plan, const std::vector<PlanarPose>& proposals, const Progress& progress) {
  constexpr double start_sigma_m = 1.0;
  std::vector<std::size_t> all(s.a.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const PlanarPose& proposal : proposals) {
    progress.at(0.0, "verifying poses of recognised scenes");
    ScoredPose found;
    for (const DbhModel& model : plan.bank) {
      PoseFit fit = refine_pose(s.a, all, s.b, {proposal, start_sigma_m, model, 0.0}, s.settings.noise_floor_m);
      fit.dbh = refit_dbh(s.a, all, s.b, fit);
      fit = refine_pose(s.a, all, s.b, fit, s.settings.noise_floor_m);
      const ScoredPose scored{fit, score_pose(s.a, s.b, fit, nullptr)};
      if (found.score.matched == 0 || scored.score.log_likelihood_ratio > found.score.log_likelihood_ratio) found = scored;
    }
    ++s.refined;
    if (found.score.matched >= 2) keep_distinct(s.best, found);
  }
  return best_of(s.best, 0) - plan.log_poses >= overwhelming;
}

Scene mirrored_scene(Scene scene) {
  scene.centre_m.x() = -scene.centre_m.x();
  return scene;
}

/// The same search with the query in a mirror.
double mirror_score(const IndexedList& a, const IndexedList& b, const SearchPlan& plan, std::size_t scenes, const ListSettings& settings, VoteSettings vote, const Progress& progress) {
  const IndexedList decoy(mirrored(a.nodes));
  SearchPlan mirrored_plan = plan;
  for (Scene& scene : mirrored_plan.scenes) scene = mirrored_scene(scene);
  vote.window.reset();  // where a rough pose is known, chance is still measured everywhere
  Search search{decoy, b, settings, vote, plan.log_poses + settings.probable_log_ratio, {}, 0};
  search_all(search, mirrored_plan, scenes, false, progress, "searching poses of the mirror image");
  return best_of(search.best, 0);
}

/// a comes first when it is the smaller list; equal lists in a fixed order, so that swapping them changes nothing.
bool in_order(const IndexedList& a, const IndexedList& b) {
  if (a.size() != b.size()) return a.size() < b.size();
  const auto before = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); };
  return !std::lexicographical_compare(b.nodes.at_m.begin(), b.nodes.at_m.end(), a.nodes.at_m.begin(), a.nodes.at_m.end(), before);
}

/// The window as seen from the other list.
PoseWindow swapped(const PoseWindow& w) {
  return {w.b_from_a.inverse(), w.b_from_a * w.about_m, w.radius_m, w.yaw_radius_rad, w.same_stand, w.accepted};
}

ListHints swapped(const ListHints& hints) {
  ListHints result;
  if (hints.years) result.years = -*hints.years;
  if (hints.rough_pose) result.rough_pose = swapped(*hints.rough_pose);
  for (const auto& [a, b] : hints.same_tree) result.same_tree.emplace_back(b, a);
  result.pairs_ask = hints.pairs_ask;
  for (const auto& pose : hints.proposals) result.proposals.push_back(pose.inverse());
  return result;
}

ListAlignment swapped(ListAlignment r) {
  r.score.centre_m = r.b_from_a * r.score.centre_m;
  r.b_from_a = r.b_from_a.inverse();
  if (r.second_best) r.second_best = r.second_best->inverse();
  r.dbh.growth_cm = -r.dbh.growth_cm;
  std::swap(r.score.a_inside, r.score.b_inside);
  std::swap(r.score.share_a, r.score.share_b);
  for (NamedPair& pair : r.contradicted) std::swap(pair.first, pair.second);
  return r;
}

/// From coordinates relative to both origins to the lists' own, and back.
PlanarPose from_nodes(const PlanarPose& pose, const IndexedList& a, const IndexedList& b) {
  return PlanarPose{b.nodes.origin_m.x(), b.nodes.origin_m.y(), 0.0} * pose * PlanarPose{-a.nodes.origin_m.x(), -a.nodes.origin_m.y(), 0.0};
}
PlanarPose to_nodes(const PlanarPose& pose, const IndexedList& a, const IndexedList& b) {
  return PlanarPose{-b.nodes.origin_m.x(), -b.nodes.origin_m.y(), 0.0} * pose * PlanarPose{a.nodes.origin_m.x(), a.nodes.origin_m.y(), 0.0};
}

ListHints to_nodes(ListHints hints, const IndexedList& a, const IndexedList& b) {
  if (hints.rough_pose) {
    hints.rough_pose->b_from_a = to_nodes(hints.rough_pose->b_from_a, a, b);
    hints.rough_pose->about_m -= a.nodes.origin_m;
  }
  for (auto& pose : hints.proposals) pose = to_nodes(pose, a, b);
  return hints;
}

void fill_acceptance(ListAlignment& result, const Search& search, double mirror, double log_poses) {
  Acceptance& acceptance = result.acceptance;
  acceptance.log_likelihood_ratio = best_of(search.best, 0);
  acceptance.second_best = best_of(search.best, 1);
  acceptance.mirror = mirror;
  acceptance.log_poses_tried = log_poses;
  acceptance.margin = acceptance.log_likelihood_ratio - std::max(acceptance.second_best, mirror);
  acceptance.probability = acceptance_probability(acceptance);
  result.poses_refined = search.refined;
  if (search.best.empty()) return;
  result.b_from_a = search.best[0].fit.b_from_a;
  result.noise_m = search.best[0].fit.noise_m;
  result.dbh = search.best[0].fit.dbh;
  result.score = search.best[0].score;
  if (search.best.size() > 1) result.second_best = search.best[1].fit.b_from_a;
}

/// Where it is known that both lists are of one stand, near one pose, the rivals are the window's other poses alone: odds of 150
/// to one against chance there, and against the second best, make a pose probable that could not prove itself.
Verdict accept_within(const Acceptance& a, const PoseWindow& window, Verdict verdict) {
  constexpr double log_odds = 5.0;
  if (window.accepted && a.log_likelihood_ratio > 0.0) return {AlignmentStatus::aligned, ""};
  if (!window.same_stand || verdict.status != AlignmentStatus::failed) return verdict;
  if (a.log_likelihood_ratio - a.log_poses_tried < log_odds || a.log_likelihood_ratio - a.second_best < log_odds) return verdict;
  return {AlignmentStatus::probable, "too few stems to prove itself; the best of the poses that the common coordinate system allows"};
}

/// What a person says holds, and is not asked to prove itself; but pairs that contradict each other make no pose, and where another
/// pose is beyond doubt and fits far better, the named pairs are mistaken (a slip of the hand), which only the person can mend.
ListAlignment judge_by_hand(Search& search, const SearchPlan& plan, const HandPose& by_hand, const Progress& progress) {
  ListAlignment result;
  result.contradicted = by_hand.contradicted;
  if (by_hand.agreeing.empty()) {
    result.reason = "the named pairs contradict each other: no pose brings two of them together";
    return result;
  }
  const ScoredPose named{by_hand.fit, score_pose(search.a, search.b, by_hand.fit, nullptr)};
  keep_distinct(search.best, named);
  search_all(search, plan, plan.scenes.size(), true, progress, "searching poses beside the named one");
  const ScoredPose& best = search.best.front();
  const double named_ratio = named.score.log_likelihood_ratio, lead = best.score.log_likelihood_ratio - named_ratio;
  const bool elsewhere = distance_between_m(best.fit.b_from_a, named.fit.b_from_a, best.score) > distinct_m(best);
  if (elsewhere && best.score.log_likelihood_ratio - plan.log_poses >= search.settings.accept_log_ratio &&
      lead >= std::max(search.settings.accept_margin, search.settings.margin_share * best.score.log_likelihood_ratio)) {
    fill_acceptance(result, search, 0.0, plan.log_poses);
    result.reason = "the named pairs ask for a pose that " + std::to_string(named.score.matched) + " stems agree with, while another one fits " +
                    std::to_string(best.score.matched) + " and far better: look at the named pairs, or align without them";
    return result;
  }
  if (elsewhere) search.best.insert(search.best.begin(), named);
  fill_acceptance(result, search, 0.0, 0.0);
  result.status = AlignmentStatus::aligned;
  return result;
}

/// In node coordinates, the smaller list first.
ListAlignment align_ordered(const IndexedList& a, const IndexedList& b, const ListHints& hints, const ListSettings& settings, int threads, const Progress& progress) {
  SearchPlan plan{query_scenes(a, settings), dbh_bank(hints.years, a.any_dbh && b.any_dbh), 0.0};
  plan.log_poses = log_poses_tried(b, plan.scenes, plan.bank.size(), hints.rough_pose);
  Search search{a, b, settings, VoteSettings{settings.peaks, threads, hints.rough_pose}, plan.log_poses + settings.probable_log_ratio, {}, 0};
  ListAlignment result;
  if (const auto by_hand = pose_by_hand(a, b, hints.same_tree, settings.noise_floor_m)) {
    ListAlignment judged = judge_by_hand(search, plan, *by_hand, progress);
    if (judged.status == AlignmentStatus::aligned || hints.pairs_ask) return judged;
    // Decisions about trees are kept as such, but a few odd ones (a swap) do not move a list that all others hold where it is.
    ListHints alone = hints;
    alone.same_tree.clear();
    ListAlignment free = align_ordered(a, b, alone, settings, threads, progress);
    if (free.status != AlignmentStatus::aligned) return judged;
    free.contradicted = pairs_apart(a, b, free.b_from_a, hints.same_tree);
    return free;
  }
  const bool settled = verify_proposals(search, plan, hints.proposals, progress.stage(0.0, 0.1));
  if (settled) plan.bank = {search.best[0].fit.dbh};  // one scene, one model: what chance and the second choice can do here
  const std::size_t scenes = search_all(search, plan, settled ? 1 : plan.scenes.size(), !settled, progress.stage(0.1, 0.6), "searching poses");
  fill_acceptance(result, search, 0.0, plan.log_poses);
  const bool refused = accept_pose(result.acceptance, settings).status == AlignmentStatus::failed;  // the decoy can only make it worse
  const std::size_t mirror_scenes = settled ? scenes : refused ? std::min(scenes, mirror_scenes_of_a_refusal) : std::max(scenes, mirror_scenes_at_least);
  if (overwhelming_lead(search.best, plan.log_poses)) plan.bank = {search.best[0].fit.dbh};  // the decoy by the model that won
  const double mirror = mirror_score(a, b, plan, mirror_scenes, settings, search.vote, progress.stage(0.6, 1.0));
  fill_acceptance(result, search, mirror, plan.log_poses);
  Verdict verdict = accept_pose(result.acceptance, settings);
  if (hints.rough_pose) verdict = accept_within(result.acceptance, *hints.rough_pose, std::move(verdict));
  result.status = verdict.status;
  result.reason = verdict.reason;
  return result;
}

}  // namespace

ListAlignment align_lists(const IndexedList& a, const IndexedList& b, const ListHints& hints, const ListSettings& settings, int threads, const Progress& progress) {
  if (a.size() < 3 || b.size() < 3) {
    ListAlignment refused;
    refused.reason = "fewer than three stems with a place: nothing to compare";
    return refused;
  }
  const ListHints in_nodes = to_nodes(hints, a, b);
  ListAlignment result = in_order(a, b) ? align_ordered(a, b, in_nodes, settings, threads, progress)
                                        : swapped(align_ordered(b, a, swapped(in_nodes), settings, threads, progress));
  result.b_from_a = from_nodes(result.b_from_a, a, b);
  if (result.second_best) result.second_best = from_nodes(*result.second_best, a, b);
  result.score.centre_m += a.nodes.origin_m;
  return result;
}

}  // namespace stemwise
