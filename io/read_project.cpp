#include <charconv>
#include <cmath>
#include <filesystem>

#include "io/exact_number.hpp"
#include "io/gdal_session.hpp"
#include "io/project_file.hpp"
#include "io/project_tables.hpp"
#include "io/read_gis.hpp"

namespace stemwise {
namespace {

namespace schema = project_tables;

/// Not damage: this program is too old for the file.
struct NewerVersion {};

[[noreturn]] void damaged(const std::string& what) { throw TableError(what); }

std::vector<double> numbers(const std::string& text, std::size_t count, const char* what) {
  const auto values = parse_exact_list(text);
  if (!values || (count > 0 && values->size() != count)) damaged(std::string(what) + " cannot be read");
  return *values;
}

RigidTransform pose_from(const std::string& text) {
  const std::vector<double> n = numbers(text, 12, "a pose");
  RigidTransform pose;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) pose.rotation(r, c) = n[static_cast<std::size_t>(3 * r + c)];
    pose.translation_m(r) = n[static_cast<std::size_t>(9 + r)];
  }
  return pose;
}

std::int64_t whole(const std::string& text, const char* what) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) damaged(std::string(what) + " is not a whole number");
  return value;
}

StemStatus status_from(const std::string& word) {
  if (const auto status = stem_status_from(word)) return *status;
  damaged("unknown stem status " + word);
}

std::optional<Date> date_from(std::optional<std::int64_t> days) {
  return days ? std::optional(Date{static_cast<int>(*days)}) : std::nullopt;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = text.find('\n', from);
    lines.push_back(text.substr(from, to - from));
    from = to == std::string::npos ? text.size() : to + 1;
  }
  return lines;
}

CoverageSource coverage_source_from(const std::string& word) {
  for (const CoverageSource source : {CoverageSource::stems, CoverageSource::frames, CoverageSource::drawn}) {
    if (word == to_string(source)) return source;
  }
  damaged("unknown source of a coverage: " + word);
}

/// Reads the stemwise_* tables back.
class StateReader {
 public:
  explicit StateReader(GDALDataset& dataset) : dataset_(dataset) {}

  ProjectState run() {
    project();
    inventories();
    stems();
    alignments();
    matches();
    trees();
    small_tables();
    return std::move(state_);
  }

 private:
  TableReader table(const char* name, std::span<const TableField> fields) { return {dataset_, name, fields}; }

  const std::string& value(const char* key) {
    const auto it = values_.find(key);
    if (it == values_.end()) damaged(std::string(key) + " is missing");
    return it->second;
  }

  void project() {
    TableReader t = table("stemwise_project", schema::project);
    while (t.next()) values_[t.text(0)] = t.text(1);
    if (whole(value("format_version"), "format_version") > schema::format_version) throw NewerVersion{};
    state_.title = value("title");
    state_.reference.value = whole(value("reference"), "reference");
    state_.next_tree = whole(value("next_tree"), "next_tree");
    state_.next_inventory = whole(value("next_inventory"), "next_inventory");
    const auto fusion = fusion_policy_from(value("fusion"));
    if (!fusion) damaged("unknown fusion policy " + value("fusion"));
    state_.fusion = *fusion;
    const std::string& kind = value("georeference_kind");
    Georeference& g = state_.georeference;
    g.kind = kind == "anchor" ? GeoreferenceKind::anchor : kind == "crs" ? GeoreferenceKind::crs : GeoreferenceKind::none;
    const std::vector<double> n = numbers(value("georeference"), 8, "the georeference");
    g.origin = {n[0], n[1], n[2]};
    g.anchored_point_m = {n[3], n[4], n[5]};
    g.azimuth_deg = n[6];
    g.sd_m = n[7];
    g.epsg = static_cast<int>(whole(value("georeference_epsg"), "georeference_epsg"));
    g.method = value("georeference_method");
    georeference_detail(g);
  }

  /// What files of older versions do not have.
  void georeference_detail(Georeference& g) {
    if (!values_.contains("georeference_detail")) return;
    const std::vector<double> n = numbers(value("georeference_detail"), 6, "the georeference");
    g.roll_deg = n[0];
    g.pitch_deg = n[1];
    g.azimuth_sd_deg = n[2];
    g.geoid = {value("georeference_geoid"), n[3], n[4], n[5]};
    for (const std::string& line : lines_of(value("georeference_residuals"))) {
      const std::size_t tab = line.find('\t');
      const std::vector<double> r = numbers(line.substr(0, tab), 3, "a residual of the georeference");
      g.residuals.push_back({tab == std::string::npos ? "" : line.substr(tab + 1), r[1], r[2] < 0.0 ? std::nullopt : std::optional(r[2]), r[0] != 0.0});
    }
  }

  void inventories() {
    TableReader t = table("stemwise_inventories", schema::inventories);
    while (t.next()) {
      auto inventory = std::make_shared<Inventory>();
      inventory->id.value = t.integer(0);
      inventory->name = t.text(1);
      inventory->date = date_from(t.optional_integer(2));
      inventory->source.path = t.text(4);
      inventory->source.format = t.text(5);
      if (const auto epsg = t.optional_integer(6)) inventory->source.epsg = static_cast<int>(*epsg);
      inventory->source.notes = lines_of(t.text(7));
      if (t.integer(8) != 0) state_.tree_of_stem[inventory->id];
      inventories_[inventory->id] = inventory;
      state_.inventories.push_back(inventory);
    }
  }

  /// What no reader lets in: a number that another program or a broken disk put there. Far beyond anything measured, so that
  /// whatever was written can be read.
  static void check_stem(const Stem& s, const std::string& inventory) {
    constexpr double largest_m = 1e12, largest_dbh_m = 1e3;
    const auto place = [&](double v) { return std::isfinite(v) && std::abs(v) <= largest_m; };
    const auto diameter = [&](const std::optional<double>& v) { return !v || (*v >= 0.0 && *v <= largest_dbh_m); };
    if (!place(s.x_m) || !place(s.y_m) || !place(s.z_m.value_or(0.0))) damaged("stem " + s.source_id + " of " + inventory + " lies off the earth");
    if (!diameter(s.dbh_m) || !diameter(s.dbh_approximation_m)) damaged("stem " + s.source_id + " of " + inventory + " has an impossible diameter");
  }

  static Stem stem_from(const TableReader& t) {
    Stem s;
    s.source_id = t.text(2);
    s.source_row = t.integer(3);
    s.x_m = t.real(4);
    s.y_m = t.real(5);
    s.z_m = t.optional_real(6);
    s.dbh_m = t.optional_real(7);
    s.dbh_approximation_m = t.optional_real(8);
    if (!t.is_null(9)) s.axis = Eigen::Vector3d(t.real(9), t.real(10), t.real(11));
    s.height_m = t.optional_real(12);
    s.reconstructed = t.integer(13) != 0;
    s.score = t.real(14);
    s.number_clusters = static_cast<int>(t.integer(15));
    s.times_seen = static_cast<int>(t.integer(16));
    s.status = status_from(t.text(17));
    s.date = date_from(t.optional_integer(18));
    s.species = t.text(19);
    s.note = t.text(20);
    return s;
  }

  void stems() {
    TableReader t = table("stemwise_stems", schema::stems);
    while (t.next()) {
      const auto inventory = inventories_.find(InventoryId{t.integer(0)});
      if (inventory == inventories_.end()) damaged("a stem belongs to no inventory");
      auto& stems = inventory->second->stems;
      if (t.integer(1) != static_cast<std::int64_t>(stems.size())) damaged("stems of " + inventory->second->name + " are missing");
      stems.push_back(stem_from(t));
      check_stem(stems.back(), inventory->second->name);
      if (const auto tree = t.optional_integer(21)) state_.tree_of_stem[inventory->first].push_back(TreeId{*tree});
    }
    check_rows("rows_stems", t.rows());
  }

  void check_rows(const char* key, std::int64_t rows) {
    if (whole(value(key), key) != rows) damaged("it is incomplete: " + std::string(key) + " should be " + value(key) + " and is " + std::to_string(rows));
  }

  InventoryId known_inventory(std::int64_t id, const char* what) const {
    if (!inventories_.contains(InventoryId{id})) damaged(std::string(what) + " names inventory " + std::to_string(id) + ", which is not there");
    return InventoryId{id};
  }

  StemRef known_stem(std::int64_t inventory, std::int64_t index, const char* what) const {
    const InventoryId id = known_inventory(inventory, what);
    if (index < 0 || index >= static_cast<std::int64_t>(inventories_.at(id)->stems.size())) {
      damaged(std::string(what) + " names stem " + std::to_string(index) + " of inventory " + std::to_string(inventory) + ", which is not there");
    }
    return {id, index};
  }

  void alignments() {
    TableReader t = table("stemwise_alignments", schema::alignments);
    while (t.next()) {
      InventoryAlignment a;
      a.inventory = known_inventory(t.integer(0), "an alignment");
      const auto status = alignment_status_from(t.text(1));
      if (!status) damaged("unknown alignment status " + t.text(1));
      a.status = *status;
      a.reason = t.text(2);
      a.reference_from_inventory = pose_from(t.text(3));
      const std::string observed = t.text(4);
      for (std::size_t i = 0; i < a.observed.seen.size(); ++i) a.observed.seen[i] = i < observed.size() && observed[i] == '1';
      a.overlap = t.real(5);
      a.position_noise_m = t.real(6);
      a.acceptance = {t.real(7), t.real(8), t.real(9), t.real(10), t.real(11), t.real(12)};
      a.matched = static_cast<int>(t.integer(13));
      a.residual_rms_m = t.real(14);
      if (!t.is_null(15)) a.second_best_pose = pose_from(t.text(15));
      state_.alignments[a.inventory] = a;
    }
  }

  void matches() {
    TableReader t = table("stemwise_matches", schema::matches);
    while (t.next()) {
      Match m;
      m.a = known_stem(t.integer(0), t.integer(1), "a match");
      m.b = known_stem(t.integer(2), t.integer(3), "a match");
      m.distance_m = t.real(4);
      m.confidence = t.real(5);
      const auto state = match_state_from(t.text(6));
      if (!state) damaged("unknown state of a match: " + t.text(6));
      m.state = *state;
      if (!t.is_null(7)) m.second_choice = known_stem(t.integer(7), t.integer(8), "a match");
      m.second_distance_m = t.optional_real(9);
      state_.matches.emplace(t.integer(10) != 0 ? StemPair(m.b, m.a) : StemPair(m.a, m.b), m);
    }
    check_rows("rows_matches", t.rows());
  }

  void trees() {
    TableReader t = table("stemwise_trees", schema::trees);
    while (t.next()) {
      TreeRecord tree;
      tree.id.value = t.integer(0);
      const std::vector<double> refs = numbers(t.text(1), 0, "the stems of a tree");
      if (refs.size() % 2 != 0) damaged("the stems of a tree cannot be read");
      for (std::size_t i = 0; i < refs.size(); i += 2) {
        tree.stems.push_back(known_stem(static_cast<std::int64_t>(refs[i]), static_cast<std::int64_t>(refs[i + 1]), "a tree"));
      }
      if (!t.is_null(2)) {
        tree.fate_by_hand = fate_from(t.text(2));
        if (!tree.fate_by_hand) damaged("unknown fate " + t.text(2));
      }
      tree.note = t.text(3);
      tree.edited_by = t.text(4);
      state_.trees[tree.id] = tree;
    }
    check_rows("rows_trees", t.rows());
  }

  void small_tables() {
    TableReader pairs = table("stemwise_pairs", schema::pairs);
    while (pairs.next()) {
      state_.pairs.push_back({known_inventory(pairs.integer(0), "a pair"), known_inventory(pairs.integer(1), "a pair"), static_cast<int>(pairs.integer(2)),
                              static_cast<int>(pairs.integer(3))});
    }
    TableReader coverages = table("stemwise_coverages", schema::coverages);
    while (coverages.next()) {
      Coverage coverage;
      coverage.source = coverage_source_from(coverages.text(1));
      const std::vector<double> n = numbers(coverages.text(2), 0, "a coverage");
      for (std::size_t i = 0; i + 1 < n.size(); i += 2) coverage.in_inventory.corners_m.emplace_back(n[i], n[i + 1]);
      state_.coverages[known_inventory(coverages.integer(0), "a coverage")] = coverage;
    }
    TableReader errors = table("stemwise_dbh_errors", schema::dbh_errors);
    while (errors.next()) state_.dbh_error_m[known_inventory(errors.integer(0), "a DBH error")] = errors.real(1);
    TableReader settings = table("stemwise_settings", schema::settings);
    while (settings.next()) state_.settings[settings.text(0)] = settings.text(1);
    TableReader log = table("stemwise_edit_log", schema::edit_log);
    while (log.next()) state_.edit_log.push_back({log.text(1), log.text(2), log.text(3), log.text(4), log.text(5), log.text(6)});
    check_rows("rows_edit_log", log.rows());
    if (state_.reference) known_inventory(state_.reference.value, "the reference");
  }

  GDALDataset& dataset_;
  ProjectState state_;
  std::map<std::string, std::string> values_;
  std::map<InventoryId, std::shared_ptr<Inventory>> inventories_;
};

Result<ProjectState> refused(const std::string& path, std::string text, std::string help) {
  return Result<ProjectState>::failure(Issue{Severity::error, path, 0, {}, std::move(text), std::move(help)});
}

}  // namespace

bool is_project(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) || file_kind(path) != FileKind::sqlite) return false;
  const GdalMessages quiet;
  const DatasetPtr dataset = open_vector(path);
  return dataset && dataset->GetLayerByName("stemwise_project") != nullptr;
}

Result<ProjectState> read_project(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return refused(path, "there is no such file", "check the name");
  const GdalMessages messages;
  const DatasetPtr dataset = std::filesystem::is_regular_file(path, error) && file_kind(path) == FileKind::sqlite ? open_vector(path) : nullptr;
  if (!dataset || dataset->GetLayerByName("stemwise_project") == nullptr) {
    return refused(path, "is no Stemwise project" + (messages.errors().empty() ? std::string() : ": " + messages.last_error()),
                   "open a project, or read a stem list as an inventory");
  }
  try {
    ProjectState state = StateReader(*dataset).run();
    if (!messages.errors().empty()) return refused(path, "is damaged: " + messages.last_error(), "open its last copy");
    return state;
  } catch (const NewerVersion&) {
    return refused(path, "needs a newer Stemwise: it was written by one, in a form that this version does not know", "install the newest version; the file itself is in order");
  } catch (const TableError& problem) {
    return refused(path, std::string("is damaged: ") + problem.what(), "open its last copy");
  }
}

}  // namespace stemwise
