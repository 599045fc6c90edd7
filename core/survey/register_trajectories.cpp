#include "core/survey/register_trajectories.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/survey/build_global_inventory.hpp"
#include "core/survey/level_by_axes.hpp"
#include "core/survey/merge_coincident.hpp"
#include "core/survey/move_frames.hpp"
#include "core/survey/odometry_scale.hpp"
#include "core/survey/trajectory_windows.hpp"

namespace stemwise {
namespace {

constexpr double scene_sd_m = 0.15, scene_height_sd_m = 0.3, scene_yaw_sd_rad = 0.02, scene_tilt_sd_rad = 0.03;
constexpr double window_sd_m = 0.08, window_yaw_sd_rad = 0.01;
constexpr double unknown_m = 100.0;        // a bare list says nothing about height; it stands upright, and so do levelled frames:
constexpr double window_tilt_sd_rad = 0.02;  // a way free to lean would rather lean than shrink
constexpr int list_rounds = 4;                          // windows are cut again from the corrected trajectory

bool has_way(const Inventory& survey) { return survey.frames && survey.frames->frames.size() >= 2; }

std::optional<double> years(const Inventory& from, const Inventory& to) {
  if (!from.date || !to.date) return std::nullopt;
  return years_between(*from.date, *to.date);
}

std::string scale_text(const OdometryScale& scale) {
  if (!scale.significant) return "";
  char text[160];
  std::snprintf(text, sizeof text, " Its steps were %.2f %% too %s, as the stems that neighbouring frames share tell (%d pairs of frames).", 100.0 * std::abs(scale.scale - 1.0),
                scale.scale > 1.0 ? "short" : "long", scale.links);
  return text;
}

/// All that one run carries.
class Registration {
 public:
  Registration(const std::vector<Inventory>& surveys, const RegisterSettings& settings, int threads) : surveys_(surveys), settings_(settings), threads_(threads) {
    for (const Inventory& survey : surveys) {
      level_.push_back({has_way(survey) ? level_by_axes(survey.stems, {}).level_from_survey : Eigen::Matrix3d(Eigen::Matrix3d::Identity()), Eigen::Vector3d::Zero()});
      frames_.push_back(has_way(survey) ? move_frames(*survey.frames, level_.back()) : FrameSet{});
      given_.emplace_back();
      for (const Frame& frame : frames_.back().frames) given_.back().push_back(frame.pose.survey_from_frame.translation_m);
      scale_.push_back(estimate_odometry_scale(frames_.back(), threads));
      if (scale_.back().significant) frames_.back() = with_scaled_steps(std::move(frames_.back()), scale_.back().scale);
      first_node_.push_back(nodes_);
      nodes_ += std::max<std::size_t>(1, frames_.back().frames.size());
      lists_.push_back(has_way(survey) ? std::nullopt : std::optional<IndexedList>(merge_coincident(survey.stems, settings.lists.merge_radius_m)));
    }
  }

  RegisterReport run(const Progress& progress) {
    recognise_scenes(progress.stage(0.0, 0.5));
    std::vector<RigidTransform> poses;
    const int rounds = std::any_of(lists_.begin(), lists_.end(), [](const auto& list) { return list.has_value(); }) ? list_rounds : 1;
    for (int round = 0; round < rounds; ++round) {
      place_on_lists(round, poses, progress.stage(0.5 + 0.5 * round / rounds, 0.5 + 0.5 * (round + 0.8) / rounds));
      progress.at(0.5 + 0.5 * (round + 0.8) / rounds, "Estimating trajectories");
      const std::vector<PoseEdge> edges = edges_of_graph();
      PoseGraphSettings how = settings_.graph;
      how.graduated = round == 0;
      const PoseGraphReport graph = optimise_pose_graph(poses.empty() ? first_poses() : poses, edges, first_node_[anchor()], how);
      poses = graph.poses;
      take(graph, edges.size() - constraints_.size());
    }
    return report(poses);
  }

 private:
  bool moves(std::size_t s) const { return !frames_[s].frames.empty(); }
  std::size_t anchor() const {
    for (std::size_t s = 0; s < surveys_.size(); ++s)
      if (!moves(s)) return s;
    return 0;
  }
  const RigidTransform& odometry(std::size_t s, std::size_t frame) const { return frames_[s].frames[frame].pose.survey_from_frame; }
  std::size_t node(std::size_t s, std::optional<std::size_t> frame) const { return first_node_[s] + frame.value_or(0); }

  void recognise_scenes(const Progress& progress) {
    const treeloc::Settings method = treeloc::settings_for(treeloc::Method::stemwise, "auto");
    for (std::size_t a = 0; a < surveys_.size(); ++a) {
      if (!moves(a)) continue;
      progress.at(static_cast<double>(a) / static_cast<double>(surveys_.size()), "Looking for loops in " + surveys_[a].name);
      const std::vector<treeloc::Scene> scenes = treeloc::survey_scenes(frames_[a], method, threads_);
      add_scenes(a, a, find_loops(scenes, method, progress));
      for (std::size_t b = a + 1; b < surveys_.size(); ++b) {
        if (!moves(b)) continue;
        add_scenes(a, b, treeloc::match_surveys(scenes, treeloc::survey_scenes(frames_[b], method, threads_), method, settings_.scenes, threads_, progress));
      }
    }
  }

  /// Frames that see a place again: looked for among those well before them.
  std::vector<treeloc::SceneConstraint> find_loops(const std::vector<treeloc::Scene>& scenes, const treeloc::Settings& method, const Progress& progress) const {
    const auto gap = static_cast<std::size_t>(settings_.loop_gap_frames);
    if (scenes.size() <= gap + 1) return {};
    const auto localizer = treeloc::make_localizer(method);
    localizer->add(scenes, threads_);
    const std::size_t step = std::max<std::size_t>(1, scenes.size() / static_cast<std::size_t>(settings_.scenes.most_queries));
    std::vector<treeloc::Scene> queries;
    std::vector<std::uint32_t> limits;
    std::vector<std::size_t> chosen;
    for (std::size_t i = gap + 1; i < scenes.size(); i += step) {
      queries.push_back(scenes[i]);
      limits.push_back(static_cast<std::uint32_t>(i - gap));
      chosen.push_back(i);
    }
    const auto found = treeloc::localize_all(*localizer, queries, limits, threads_, progress);
    std::vector<treeloc::SceneConstraint> loops;
    for (std::size_t q = 0; q < queries.size(); ++q) {
      if (found[q].candidates.empty()) continue;
      const treeloc::Candidate& best = found[q].candidates.front();
      if (best.score < settings_.scenes.accept_score || best.evidence < settings_.scenes.min_evidence) continue;
      loops.push_back({best.scene, chosen[q], {}, best.candidate_from_query, false, best.score, best.evidence, best.pairs});
    }
    return loops;
  }

  /// Keeps those that at least one neighbour bears out: the short cycle over both, closed by odometry (which cannot have
  /// drifted much between them), must come back to where it began.
  void add_scenes(std::size_t a, std::size_t b, const std::vector<treeloc::SceneConstraint>& found) {
    constexpr double near_m = 30.0, agree_m = 0.6, agree_per_m = 0.03;
    const auto agree = [&](const treeloc::SceneConstraint& c, const treeloc::SceneConstraint& d) {
      const RigidTransform in_a = odometry(a, c.scene_a).inverse() * odometry(a, d.scene_a), in_b = odometry(b, d.scene_b).inverse() * odometry(b, c.scene_b);
      const double apart_m = in_a.translation_m.norm() + in_b.translation_m.norm();
      if (in_a.translation_m.norm() > near_m || in_b.translation_m.norm() > near_m) return false;
      const Eigen::Vector3d off = (in_a * d.scene_a_from_scene_b * in_b).translation_m - c.scene_a_from_scene_b.translation_m;
      return off.head<2>().norm() <= agree_m + agree_per_m * apart_m;
    };
    for (std::size_t i = 0; i < found.size(); ++i) {
      const bool borne_out = std::any_of(found.begin(), found.end(), [&](const auto& other) { return &other != &found[i] && agree(found[i], other); });
      if (borne_out) constraints_.push_back({a, b, found[i].scene_a, found[i].scene_b, found[i].scene_a_from_scene_b, true, 0.0});
    }
  }

  /// Stretches of every way on every bare list; again after a first estimate, when drift within them has gone.
  void place_on_lists(int round, const std::vector<RigidTransform>& poses, const Progress& progress) {
    std::erase_if(constraints_, [](const TrajectoryConstraint& c) { return !c.frame_a; });
    for (std::size_t s = 0; s < surveys_.size(); ++s) {
      if (!moves(s) || std::none_of(lists_.begin(), lists_.end(), [](const auto& list) { return list.has_value(); })) continue;
      progress.at(static_cast<double>(s) / static_cast<double>(surveys_.size()), "Laying the way of " + surveys_[s].name + " onto the other surveys");
      FrameSet now = frames_[s];
      if (round > 0)
        for (std::size_t f = 0; f < now.frames.size(); ++f) now.frames[f].pose.survey_from_frame = poses[node(s, f)];
      const std::vector<TrajectoryWindow> windows = windows_along(now, settings_);
      for (std::size_t l = 0; l < surveys_.size(); ++l)
        if (lists_[l]) place_on_list(s, l, now, windows, round > 0 ? &poses : nullptr, progress);
    }
  }

  void place_on_list(std::size_t s, std::size_t l, const FrameSet& now, const std::vector<TrajectoryWindow>& windows, const std::vector<RigidTransform>* poses,
                     const Progress& progress) {
    std::vector<PlanarPose> guess;
    if (poses != nullptr) guess.assign(windows.size(), planar_part((*poses)[node(l, {})].inverse()));
    const auto placed = place_windows(windows, *lists_[l], years(surveys_[s], surveys_[l]), guess, settings_, threads_, progress);
    for (std::size_t w = 0; w < windows.size(); ++w) {
      if (!placed[w]) continue;
      const std::size_t frame = windows[w].middle;
      constraints_.push_back({l, s, std::nullopt, frame, placed[w]->rigid() * now.frames[frame].pose.survey_from_frame, true, 0.0});
    }
  }

  std::vector<PoseEdge> edges_of_graph() const {
    std::vector<PoseEdge> edges;
    for (std::size_t s = 0; s < surveys_.size(); ++s)
      for (std::size_t f = 1; f < frames_[s].frames.size(); ++f) {
        const RigidTransform step = odometry(s, f - 1).inverse() * odometry(s, f);
        const double step_m = step.translation_m.norm();
        edges.push_back({node(s, f - 1), node(s, f), step, 0.005 + settings_.odometry_share * step_m, 0.005 + settings_.odometry_share * step_m,
                         0.0005 + settings_.odometry_yaw_rad_per_m * step_m, 0.0005 + settings_.odometry_tilt_rad_per_m * step_m, true});
      }
    for (const TrajectoryConstraint& c : constraints_) {
      const bool on_list = !c.frame_a;
      edges.push_back({node(c.a, c.frame_a), node(c.b, c.frame_b), c.a_from_b, on_list ? window_sd_m : scene_sd_m, on_list ? unknown_m : scene_height_sd_m,
                       on_list ? window_yaw_sd_rad : scene_yaw_sd_rad, on_list ? window_tilt_sd_rad : scene_tilt_sd_rad, false});
    }
    return edges;
  }

  /// Surveys laid onto each other rigidly, by what most constraints ask for.
  std::vector<RigidTransform> first_poses() const {
    std::vector<PoseConstraint> rigid;
    const auto survey_from = [&](std::size_t s, std::optional<std::size_t> frame) { return frame ? odometry(s, *frame) : RigidTransform{}; };
    for (const TrajectoryConstraint& c : constraints_) {
      if (c.a == c.b) continue;
      const RigidTransform of_b = survey_from(c.b, c.frame_b);
      rigid.push_back({c.a, c.b, survey_from(c.a, c.frame_a) * c.a_from_b * of_b.inverse(), of_b.translation_m, 1.0});
    }
    const JointPoseReport joint = estimate_joint_poses(surveys_.size(), anchor(), rigid, settings_.joint);
    std::vector<RigidTransform> poses;
    for (std::size_t s = 0; s < surveys_.size(); ++s) {
      const RigidTransform placed = joint.reference_from_survey[s].value_or(RigidTransform{});
      for (const Frame& frame : frames_[s].frames) poses.push_back(placed * frame.pose.survey_from_frame);
      if (frames_[s].frames.empty()) poses.push_back(placed);
    }
    return poses;
  }

  void take(const PoseGraphReport& graph, std::size_t odometry_edges) {
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      constraints_[c].accepted = graph.accepted[odometry_edges + c] != 0;
      constraints_[c].residual_m = graph.residual_m[odometry_edges + c];
    }
    group_.clear();
    for (std::size_t s = 0; s < surveys_.size(); ++s) group_.push_back(graph.group[first_node_[s]]);
  }

  /// What takes the given trajectory onto the estimated one as a whole: mean turn, mean shift.
  RigidTransform gauge(std::size_t s, const std::vector<RigidTransform>& poses) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
    const auto count = static_cast<double>(frames_[s].frames.size());
    for (std::size_t f = 0; f < frames_[s].frames.size(); ++f) {
      sum += poses[node(s, f)].rotation * odometry(s, f).rotation.transpose();
      from += odometry(s, f).translation_m / count;
      to += poses[node(s, f)].translation_m / count;
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
    return {rotation, to - rotation * from};
  }

  RegisterReport report(const std::vector<RigidTransform>& poses) {
    RegisterReport result;
    result.constraints = constraints_;
    result.group = group_;
    for (std::size_t s = 0; s < surveys_.size(); ++s) {
      result.corrected.emplace_back();
      result.correction_m.push_back(0.0);
      if (!moves(s)) continue;
      const RigidTransform survey_from_graph = gauge(s, poses).inverse();
      FrameSet corrected = frames_[s];
      double sum_sq = 0.0;
      for (std::size_t f = 0; f < corrected.frames.size(); ++f) {
        const RigidTransform levelled = survey_from_graph * poses[node(s, f)];
        sum_sq += (levelled.translation_m - given_[s][f]).squaredNorm();
        corrected.frames[f].pose.survey_from_frame = level_[s].inverse() * levelled;
      }
      result.correction_m[s] = std::sqrt(sum_sq / static_cast<double>(corrected.frames.size()));
      if (result.correction_m[s] < settings_.least_drift_m) continue;
      result.corrected[s] = std::make_shared<const FrameSet>(std::move(corrected));
      note(s, result);
    }
    return result;
  }

  void note(std::size_t s, RegisterReport& result) const {
    int used = 0, rejected = 0;
    for (const TrajectoryConstraint& c : constraints_)
      if (c.a == s || c.b == s) (c.accepted ? used : rejected)++;
    char text[160];
    std::snprintf(text, sizeof text, ": the trajectory had drifted; corrected by %.2f m (root mean square) from %d constraints, %d rejected.", result.correction_m[s], used, rejected);
    result.notes.push_back(surveys_[s].name + text + scale_text(scale_[s]) + rejected_text(s));
  }

  /// The rejected constraints of a survey, the farthest off first, at most five.
  std::string rejected_text(std::size_t s) const {
    std::vector<const TrajectoryConstraint*> rejected;
    for (const TrajectoryConstraint& c : constraints_)
      if (!c.accepted && (c.a == s || c.b == s)) rejected.push_back(&c);
    if (rejected.empty()) return "";
    std::stable_sort(rejected.begin(), rejected.end(), [](const auto* p, const auto* q) { return p->residual_m > q->residual_m; });
    const auto side = [&](std::size_t survey, const std::optional<std::size_t>& frame) { return surveys_[survey].name + (frame ? " frame " + std::to_string(*frame) : ""); };
    std::string text = " Rejected:";
    for (std::size_t k = 0; k < std::min<std::size_t>(5, rejected.size()); ++k) {
      char off[40];
      std::snprintf(off, sizeof off, " (%.2f m off)", rejected[k]->residual_m);
      text += (k == 0 ? " " : ", ") + side(rejected[k]->a, rejected[k]->frame_a) + " on " + side(rejected[k]->b, rejected[k]->frame_b) + off;
    }
    return text + (rejected.size() > 5 ? " and " + std::to_string(rejected.size() - 5) + " more." : ".");
  }

  const std::vector<Inventory>& surveys_;
  const RegisterSettings& settings_;
  int threads_;
  std::vector<RigidTransform> level_;  ///< level from survey: a turn about the origin
  std::vector<FrameSet> frames_;       ///< as given but upright and to scale; empty for a bare list
  std::vector<std::vector<Eigen::Vector3d>> given_;  ///< per survey and frame: the place as given, upright
  std::vector<OdometryScale> scale_;   ///< per survey
  std::vector<std::optional<IndexedList>> lists_;
  std::vector<std::size_t> first_node_;
  std::size_t nodes_ = 0;
  std::vector<TrajectoryConstraint> constraints_;
  std::vector<std::size_t> group_;
};

}  // namespace

Fields RegisterSettings::fields() {
  return {{"register.loop_gap_frames", "", "Frames nearer to each other than this are no loop.", &loop_gap_frames},
          {"register.window_m", "m", "Length of way that is laid onto a bare list at once.", &window_m},
          {"register.window_step_m", "m", "From one such stretch to the next.", &window_step_m},
          {"register.least_drift_m", "m", "A trajectory that would change by less stays as it is.", &least_drift_m},
          {"register.odometry_share", "", "Standard deviation of a step of odometry, of its length.", &odometry_share},
          {"register.odometry_yaw_rad_per_m", "rad", "Standard deviation of its heading per metre.", &odometry_yaw_rad_per_m},
          {"register.odometry_tilt_rad_per_m", "rad", "Standard deviation of its tilt per metre.", &odometry_tilt_rad_per_m},
          {"register.list_accept_log_ratio", "", "Evidence that a stretch next to a placed one needs.", &list_accept_log_ratio}};
}

RegisterReport register_trajectories(const std::vector<Inventory>& surveys, const RegisterSettings& settings, int threads, const Progress& progress) {
  if (std::none_of(surveys.begin(), surveys.end(), has_way)) {
    RegisterReport nothing;
    nothing.corrected.resize(surveys.size());
    nothing.correction_m.resize(surveys.size(), 0.0);
    return nothing;
  }
  return Registration(surveys, settings, threads).run(progress);
}

Registered correct_trajectories(std::span<const std::shared_ptr<const Inventory>> surveys, const std::vector<bool>& free, const RegisterSettings& settings,
                                int threads, const Progress& progress) {
  std::vector<Inventory> taking_part;
  for (std::size_t s = 0; s < surveys.size(); ++s) {
    taking_part.push_back(*surveys[s]);
    if (!free[s]) taking_part.back().frames.reset();
  }
  Registered result;
  result.corrected.resize(surveys.size());
  result.report = register_trajectories(taking_part, settings, threads, progress);
  for (std::size_t s = 0; s < surveys.size(); ++s) {
    if (!result.report.corrected[s]) continue;
    Inventory corrected = *surveys[s];
    corrected.frames = result.report.corrected[s];
    corrected.stems.clear();
    corrected = with_global_stems(std::move(corrected), {}, progress.stage(1.0, 1.0));
    for (const std::string& note : result.report.notes)
      if (note.starts_with(corrected.name + ": ")) corrected.source.notes.push_back(note);
    result.corrected[s] = std::make_shared<const Inventory>(std::move(corrected));
  }
  return result;
}

}  // namespace stemwise
