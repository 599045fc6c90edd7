#include <cpl_conv.h>

#include <filesystem>

#include "core/survey/tables.hpp"
#include "io/earth_frame.hpp"
#include "io/exact_number.hpp"
#include "io/gdal_session.hpp"
#include "io/keep_layers.hpp"
#include "io/project_file.hpp"
#include "io/project_layers.hpp"
#include "io/project_tables.hpp"
#include "io/replace_file.hpp"
#include "io/write_layers.hpp"

namespace stemwise {
namespace {

namespace schema = project_tables;

std::string pose_text(const RigidTransform& pose) {
  std::array<double, 12> numbers{};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) numbers[static_cast<std::size_t>(3 * r + c)] = pose.rotation(r, c);
    numbers[static_cast<std::size_t>(9 + r)] = pose.translation_m(r);
  }
  return exact_list(numbers);
}

std::string lines(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += note + "\n";
  return text;
}

std::optional<std::int64_t> days(const std::optional<Date>& date) { return date ? std::optional<std::int64_t>(date->days) : std::nullopt; }

std::array<double, 6> georeference_detail(const Georeference& g) {
  return {g.roll_deg, g.pitch_deg, g.azimuth_sd_deg, g.geoid.height_m, g.geoid.slope_east, g.geoid.slope_north};
}

/// A line per residual: used (1 or 0), residual, leave-one-out residual (-1: none), name.
std::string residual_lines(const std::vector<ControlResidual>& residuals) {
  std::string text;
  for (const ControlResidual& r : residuals) {
    const std::array<double, 3> numbers = {r.used ? 1.0 : 0.0, r.residual_m, r.leave_one_out_m.value_or(-1.0)};
    text += exact_list(numbers) + "\t" + r.name + "\n";
  }
  return text;
}

/// Writes the stemwise_* tables.
class StateWriter {
 public:
  StateWriter(GDALDataset& dataset, const ProjectState& state) : dataset_(dataset), state_(state) {}

  void run() {
    inventories();
    stems();
    alignments();
    matches();
    trees();
    small_tables();
    project();  // last: it holds how many rows the others have
  }
  /// As it stands in the file, after `run`.
  const std::string& fingerprint() const { return written_; }

 private:
  TableWriter table(const char* name, std::span<const TableField> fields) { return {dataset_, name, fields, fingerprint_}; }

  void inventories() {
    TableWriter t = table("stemwise_inventories", schema::inventories);
    for (const auto& inventory : state_.inventories) {
      const auto& source = inventory->source;
      const std::optional<std::int64_t> epsg = source.epsg ? std::optional<std::int64_t>(*source.epsg) : std::nullopt;
      const std::optional<std::string> date = inventory->date ? std::optional(to_string(*inventory->date)) : std::nullopt;
      t.row(inventory->id.value, inventory->name, days(inventory->date), date, source.path, source.format, epsg, lines(source.notes),
            state_.tree_of_stem.contains(inventory->id));
    }
  }

  void stems() {
    TableWriter t = table("stemwise_stems", schema::stems);
    for (const auto& inventory : state_.inventories) {
      const auto trees = state_.tree_of_stem.find(inventory->id);
      for (std::size_t i = 0; i < inventory->stems.size(); ++i) {
        const Stem& s = inventory->stems[i];
        const bool has_tree = trees != state_.tree_of_stem.end() && i < trees->second.size();
        const auto axis = [&s](int k) { return s.axis ? std::optional((*s.axis)(k)) : std::nullopt; };
        t.row(inventory->id.value, static_cast<std::int64_t>(i), s.source_id, s.source_row, s.x_m, s.y_m, s.z_m, s.dbh_m, s.dbh_approximation_m, axis(0),
              axis(1), axis(2), s.height_m, s.reconstructed, s.score, s.number_clusters, s.times_seen, to_string(s.status), days(s.date), s.species,
              s.note, has_tree ? std::optional(trees->second[i].value) : std::nullopt);
      }
    }
    stem_rows_ = t.rows();
  }

  void alignments() {
    TableWriter t = table("stemwise_alignments", schema::alignments);
    for (const auto& [id, a] : state_.alignments) {
      std::string observed;
      for (const bool seen : a.observed.seen) observed += seen ? '1' : '0';
      const auto second = a.second_best_pose ? std::optional(pose_text(*a.second_best_pose)) : std::nullopt;
      t.row(id.value, to_string(a.status), a.reason, pose_text(a.reference_from_inventory), observed, a.overlap, a.position_noise_m,
            a.acceptance.log_likelihood_ratio, a.acceptance.log_poses_tried, a.acceptance.margin, a.acceptance.second_best, a.acceptance.mirror,
            a.acceptance.probability, a.matched, a.residual_rms_m, second);
    }
  }

  void matches() {
    TableWriter t = table("stemwise_matches", schema::matches);
    for (const auto& [key, m] : state_.matches) {
      const auto second_inventory = m.second_choice ? std::optional(m.second_choice->inventory.value) : std::nullopt;
      const auto second_stem = m.second_choice ? std::optional(m.second_choice->index) : std::nullopt;
      t.row(m.a.inventory.value, m.a.index, m.b.inventory.value, m.b.index, m.distance_m, m.confidence, to_string(m.state), second_inventory, second_stem,
            m.second_distance_m, key.first != m.a);
    }
    match_rows_ = t.rows();
  }

  void trees() {
    TableWriter t = table("stemwise_trees", schema::trees);
    for (const auto& [id, tree] : state_.trees) {
      std::string stems;
      for (const StemRef& s : tree.stems) stems += std::to_string(s.inventory.value) + " " + std::to_string(s.index) + " ";
      const auto fate = tree.fate_by_hand ? std::optional(std::string(to_string(*tree.fate_by_hand))) : std::nullopt;
      t.row(id.value, stems, fate, tree.note, tree.edited_by);
    }
    tree_rows_ = t.rows();
  }

  void small_tables() {
    TableWriter pairs = table("stemwise_pairs", schema::pairs);
    for (const PairReport& p : state_.pairs) pairs.row(p.a.value, p.b.value, p.constraints, p.accepted);
    TableWriter coverages = table("stemwise_coverages", schema::coverages);
    for (const auto& [id, coverage] : state_.coverages) {
      std::vector<double> corners;
      for (const Eigen::Vector2d& c : coverage.in_inventory.corners_m) corners.insert(corners.end(), {c.x(), c.y()});
      coverages.row(id.value, to_string(coverage.source), exact_list(corners));
    }
    TableWriter errors = table("stemwise_dbh_errors", schema::dbh_errors);
    for (const auto& [id, error_m] : state_.dbh_error_m) errors.row(id.value, error_m);
    TableWriter settings = table("stemwise_settings", schema::settings);
    for (const auto& [key, value] : state_.settings) settings.row(key, value);
    TableWriter log = table("stemwise_edit_log", schema::edit_log);
    std::int64_t number = 0;
    for (const EditLogEntry& e : state_.edit_log) log.row(++number, e.time_utc, e.author, e.what, e.before, e.after, e.note);
    log_rows_ = number;
  }

  void project() {
    TableWriter t = table("stemwise_project", schema::project);
    const Georeference& g = state_.georeference;
    const std::array<double, 8> georeference = {g.origin.latitude_deg, g.origin.longitude_deg, g.origin.height_m,       g.anchored_point_m.x(),
                                                g.anchored_point_m.y(), g.anchored_point_m.z(), g.azimuth_deg, g.sd_m};
    const char* kind = g.kind == GeoreferenceKind::none ? "none" : g.kind == GeoreferenceKind::anchor ? "anchor" : "crs";
    const std::vector<std::pair<const char*, std::string>> values = {{"format_version", std::to_string(schema::format_version)},
                                                                     {"title", state_.title},
                                                                     {"reference", std::to_string(state_.reference.value)},
                                                                     {"next_tree", std::to_string(state_.next_tree)},
                                                                     {"next_inventory", std::to_string(state_.next_inventory)},
                                                                     {"fusion", to_string(state_.fusion)},
                                                                     {"georeference_kind", kind},
                                                                     {"georeference", exact_list(georeference)},
                                                                     {"georeference_epsg", std::to_string(g.epsg)},
                                                                     {"georeference_method", g.method},
                                                                     {"georeference_detail", exact_list(georeference_detail(g))},
                                                                     {"georeference_geoid", g.geoid.name},
                                                                     {"georeference_residuals", residual_lines(g.residuals)},
                                                                     {"rows_stems", std::to_string(stem_rows_)},
                                                                     {"rows_matches", std::to_string(match_rows_)},
                                                                     {"rows_trees", std::to_string(tree_rows_)},
                                                                     {"rows_edit_log", std::to_string(log_rows_)}};
    for (const auto& [key, value] : values) t.row(key, value);
    t.row(schema::fingerprint_key, written_ = fingerprint_.text());
  }

  GDALDataset& dataset_;
  const ProjectState& state_;
  std::int64_t stem_rows_ = 0, match_rows_ = 0, tree_rows_ = 0, log_rows_ = 0;
  Fingerprint fingerprint_;
  std::string written_;
};

Result<Done> agree(const std::string& path, const std::optional<ProjectStamp>& known) {
  if (!known || !is_changed_since(*known, path)) return Done{};
  return Result<Done>::failure(Issue{Severity::error, path, 0, {}, "was changed by another window or program in the meantime, so nothing was written", "do it again on what it holds now"});
}

/// The map layers, in the georeference's system; local coordinates where that has no place for them.
Issues write_map_layers(GDALDataset& dataset, const ProjectState& state) {
  auto frame = EarthFrame::of(state.georeference);
  if (!frame) frame = EarthFrame::of(Georeference{});
  const Tables tables = derive_tables(state);
  for (const Layer& layer : project_layers(state, tables, *frame)) {
    if (Issues issues = write_layer(dataset, layer, {}); has_error(issues)) return issues;
  }
  return {};
}

}  // namespace

Result<ProjectStamp> write_project(const ProjectState& state, const std::string& path, const std::optional<ProjectStamp>& known) {
  const GdalMessages messages;
  const GdalOption no_sync("OGR_SQLITE_SYNCHRONOUS", "OFF");  // flushed once, before the rename
  const GdalOption date("OGR_CURRENT_DATE", timestamp_utc_ms());
  const std::string temporary = temporary_beside(path);
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  const auto give_up = [&](const std::string& why) {
    std::filesystem::remove(temporary, ignored);
    std::filesystem::remove(temporary + "-journal", ignored);
    return Result<ProjectStamp>::failure(cannot_write(path, why));
  };
  Issues issues;
  ProjectStamp stamp;
  DatasetPtr dataset = create_dataset("GPKG", temporary);
  if (!dataset) return give_up(messages.last_error());
  try {
    dataset->StartTransaction();
    if (const Issues wrong = write_map_layers(*dataset, state); has_error(wrong)) {
      dataset.reset();
      return give_up(wrong.front().text);
    }
    StateWriter writer(*dataset, state);
    writer.run();
    stamp.text = writer.fingerprint();
    issues = write_layer_styles(path, *dataset);
    const bool committed = dataset->CommitTransaction() == OGRERR_NONE;
    const Issues lost = keep_foreign_layers(path, *dataset);  // GDAL copies a layer in a transaction of its own
    issues.insert(issues.end(), lost.begin(), lost.end());
    dataset.reset();
    if (!committed || !messages.errors().empty()) return give_up(messages.last_error());
  } catch (const TableError& error) {
    dataset.reset();
    return give_up(error.what() + (messages.errors().empty() ? std::string() : ": " + messages.last_error()));
  }
  const Result<Done> done = replace_file(temporary, path, [&] { return agree(path, known); });
  for (Issue& issue : issues) issue.file = path;
  issues.insert(issues.begin(), done.issues.begin(), done.issues.end());
  return done ? Result<ProjectStamp>(std::move(stamp), std::move(issues)) : Result<ProjectStamp>::failure(std::move(issues));
}

}  // namespace stemwise
