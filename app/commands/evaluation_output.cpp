#include "app/commands/evaluation_output.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace stemwise {
namespace {

using Json = nlohmann::ordered_json;

Json pose_json(const treeloc::PoseMetrics& m) {
  return {{"r50", m.r50}, {"sr", m.sr}, {"ate_m", m.ate_m}, {"are_deg", m.are_deg}};
}

/// Times, and what came from the cache: all that may differ between two runs.
Json timing_json(const treeloc::Evaluation& e, const EvaluationAbout& about) {
  return {{"threads", about.threads},
          {"read_s", about.read_s},
          {"describe_s", about.describe_s},
          {"describe_ms_per_scene", e.timing.describe_ms_per_scene},
          {"index_s", about.index_s},
          {"query_from_cache", about.query_from_cache},
          {"map_from_cache", about.map_from_cache},
          {"cache_write_s", about.cache_write_s},
          {"retrieve_ms_per_query", e.timing.retrieve_ms_per_query},
          {"verify_ms_per_query", e.timing.verify_ms_per_query},
          {"query_ms_mean", e.timing.query_ms_mean},
          {"query_ms_p99", e.timing.query_ms_p99},
          {"peak_rss_mb", about.peak_rss_mb}};
}

std::string number(double value, const char* format = "%.6f") {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

/// Standard deviations from the covariance, along the axes of the candidate's frame, and how far the truth is by it: the truth that
/// calibration counts by, between surveys moved by the one SE(3).
std::string deviations_csv(const treeloc::QueryRow& row) {
  std::string csv;
  for (int i = 0; i < 6; ++i) {
    const double sd = std::sqrt(row.covariance(i, i));
    csv += "," + (row.found() ? number(i < 3 ? sd : degrees(sd)) : "");
  }
  return csv + "," + (row.found() ? number(row.mahalanobis_sq, "%.4f") : "");
}

std::string pose_text(const char* name, const treeloc::PoseMetrics& m) {
  return std::string("  ") + name + ": R@50 " + number(m.r50, "%.4f") + ", SR " + number(m.sr, "%.4f") + ", ATE " +
         number(m.ate_m, "%.3f") + " m, ARE " + number(m.are_deg, "%.3f") + " deg\n";
}

}  // namespace

std::string evaluation_json(const treeloc::Evaluation& e, const EvaluationAbout& about) {
  Json json{{"mode", about.mode},
            {"method", about.method},
            {"query", about.query},
            {"map", about.map},
            {"map_mode", about.map_mode},
            {"queries", e.rows.size()},
            {"map_scenes", e.map_scenes},
            {"recall_at_1", e.retrieval.recall_at_1},
            {"mr", e.retrieval.mr},
            {"mf1", e.retrieval.mf1},
            {"auc", e.retrieval.auc},
            {"pose_2d", pose_json(e.pose_2d)},
            {"pose_3d", pose_json(e.pose_3d)}};
  if (e.pose_3d_truth_aligned) json["pose_3d_truth_aligned"] = pose_json(*e.pose_3d_truth_aligned);
  json["acceptance"] = {{"threshold", e.acceptance_score},
                        {"queries_within_30_m", e.queries_within_30_m},
                        {"accepted", e.accepted},
                        {"accepted_wrong_by_more_than_1_m", e.accepted_wrong},
                        {"accepted_wrong_by_more_than_1_m_in_space", e.accepted_wrong_in_space},
                        {"queries_without_truth", e.queries_without_truth},
                        {"accepted_without_truth", e.accepted_without_truth},
                        {"highest_score_without_truth", e.highest_score_without_truth}};
  json["calibration"] = {{"poses", e.calibration.poses},
                         {"inside_95", e.calibration.inside_95},
                         {"inside_95_position", e.calibration.inside_95_position},
                         {"inside_95_rotation", e.calibration.inside_95_rotation},
                         {"median_position_sd_m", e.calibration.median_position_sd_m},
                         {"median_rotation_sd_deg", e.calibration.median_rotation_sd_deg}};
  json["tilt_observed"] = e.tilt_observed;
  json["timing"] = timing_json(e, about);
  return json.dump(2) + "\n";
}

std::string evaluation_csv(const treeloc::Evaluation& e) {
  std::string csv =
      "query,candidate,positive,score,dx_m,dy_m,dz_m,droll_deg,dpitch_deg,dyaw_deg,pairs,votes,candidate_distance_m,"
      "sd_x_m,sd_y_m,sd_z_m,sd_roll_deg,sd_pitch_deg,sd_yaw_deg,mahalanobis_sq\n";
  for (std::size_t i = 0; i < e.rows.size(); ++i) {
    const treeloc::QueryRow& row = e.rows[i];
    csv += std::to_string(row.query) + "," + (row.found() ? std::to_string(row.candidate) : "") + "," +
           (row.positive ? "1" : "0") + "," + number(row.score);
    for (const double v : row.error.position_m) csv += "," + (row.found() ? number(v) : "");
    for (const double v : row.error.angle_deg) csv += "," + (row.found() ? number(v) : "");
    csv += "," + std::to_string(row.pairs) + "," + std::to_string(row.votes) + "," +
           (row.found() ? number(row.candidate_distance_m) : "") + deviations_csv(e.truth_aligned_rows.empty() ? row : e.truth_aligned_rows[i]) + "\n";
  }
  return csv;
}

std::string evaluation_text(const treeloc::Evaluation& e, const EvaluationAbout& about) {
  std::string text = about.query + (about.mode == "inter" ? " in " + about.map : "") + ", " + about.mode + ", " + about.method +
                     ": " + std::to_string(e.rows.size()) + " queries with truth, " + std::to_string(e.map_scenes) + " scenes\n";
  text += "  R@1 " + number(e.retrieval.recall_at_1, "%.4f") + ", MR " + number(e.retrieval.mr, "%.4f") + ", MF1 " +
          number(e.retrieval.mf1, "%.4f") + ", AUC " + number(e.retrieval.auc, "%.4f") + "\n";
  text += pose_text("2D", e.pose_2d) + pose_text("3D", e.pose_3d);
  if (e.pose_3d_truth_aligned) text += pose_text("3D, one SE(3) fitted between the truths", *e.pose_3d_truth_aligned);
  text += "  accepted (score " + number(e.acceptance_score, "%.2f") + "): " + std::to_string(e.accepted) + " of " + std::to_string(e.queries_within_30_m) +
          " with a scene within 30 m, of them wrong by more than 1 m: " + std::to_string(e.accepted_wrong) +
          "; with nothing within 30 m: " + std::to_string(e.accepted_without_truth) + " of " + std::to_string(e.queries_without_truth) +
          "\n";
  text += "  truth inside the 95 % region of its pose: " + number(100.0 * e.calibration.inside_95, "%.1f") + " % of " +
          std::to_string(e.calibration.poses) + "\n";
  text += "  read " + number(about.read_s, "%.2f") + " s, describe " + number(e.timing.describe_ms_per_scene, "%.3f") +
          " ms a scene, query " + number(e.timing.query_ms_mean, "%.2f") + " ms (p99 " + number(e.timing.query_ms_p99, "%.2f") +
          "), " + number(about.peak_rss_mb, "%.0f") + " MB\n";
  return text;
}

}  // namespace stemwise
