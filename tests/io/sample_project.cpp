#include "tests/io/sample_project.hpp"

#include "core/base/random.hpp"

namespace stemwise {
namespace {

std::shared_ptr<Inventory> survey(std::int64_t id, const std::string& name, int year, int stems, std::uint64_t seed) {
  auto inventory = std::make_shared<Inventory>();
  inventory->id = InventoryId{id};
  inventory->name = name;
  inventory->date = date_from_civil(year, 5, 4);
  inventory->source = {"/data/" + name + ".csv", "table", {"dbh: column DBH, cm (by header)", "id: row number"}, std::nullopt};
  Random random(seed);
  const auto side = static_cast<double>(static_cast<int>(std::sqrt(stems)) * 4);
  for (int i = 0; i < stems; ++i) {
    Stem s;
    s.source_id = std::to_string(1000 + i);
    s.source_row = i + 2;
    s.x_m = random.uniform(0.0, side);
    s.y_m = random.uniform(0.0, side);
    s.z_m = random.uniform(0.0, 10.0);
    s.dbh_m = random.uniform(0.1, 0.6) + 0.005 * static_cast<double>(id);
    s.species = i % 2 == 0 ? "Fagus" : "Picea";
    inventory->stems.push_back(s);
  }
  return inventory;
}

void add_match(ProjectState& state, StemRef a, StemRef b, MatchState word, double distance_m) {
  Match m;
  m.a = a;
  m.b = b;
  m.state = word;
  m.distance_m = distance_m;
  m.confidence = 1.0 / 3.0;
  state.matches.emplace(ordered(a, b), m);
}

}  // namespace

ProjectState sample_project() {
  ProjectState state;
  state.title = "Brunnenkopf – Süd \"A\"";
  auto first = survey(1, "2019", 2019, 12, 7);
  auto second = survey(3, "2023", 2023, 12, 7);
  auto third = survey(4, "no date", 2024, 5, 9);
  third->date.reset();
  third->source.epsg = 32756;
  Stem& odd = second->stems[3];
  odd.source_id = "A-17/b";
  odd.z_m.reset();
  odd.dbh_m.reset();
  odd.dbh_approximation_m = 0.1 + 0.2;
  odd.axis = Eigen::Vector3d(0.1, -0.2, 0.97).normalized();
  odd.height_m = 1.0 / 3.0;
  odd.reconstructed = false;
  odd.score = 0.123456789012345678;
  odd.number_clusters = 4;
  odd.times_seen = 9;
  odd.status = StemStatus::dead;
  odd.date = date_from_civil(2023, 6, 1);
  odd.note = "line one\nline; \"two\", Käfer";
  odd.x_m = 412801.43251234567;
  odd.y_m = 5280085.535000001;
  second->stems[5].status = StemStatus::unknown;
  second->stems[6].status = StemStatus::removed;
  state.inventories = {first, second, third};
  state.reference = first->id;
  InventoryAlignment aligned;
  aligned.inventory = second->id;
  aligned.status = AlignmentStatus::aligned;
  aligned.reference_from_inventory = RigidTransform::planar(312.123456789, -17.0 / 3.0, 0.7);
  aligned.observed.set(Dof::x);
  aligned.observed.set(Dof::y);
  aligned.observed.set(Dof::yaw);
  aligned.overlap = 0.61;
  aligned.position_noise_m = 0.1;
  aligned.acceptance = {2214.3, 31.2, 2180.1, 34.2, 20.0, 0.9999};
  aligned.matched = 9;
  aligned.residual_rms_m = 0.071;
  aligned.second_best_pose = RigidTransform::planar(1, 2, 3);
  state.alignments[second->id] = aligned;
  InventoryAlignment failed;
  failed.inventory = third->id;
  failed.status = AlignmentStatus::failed;
  failed.reason = "no pose is better than chance";
  state.alignments[third->id] = failed;
  InventoryAlignment reference;
  reference.inventory = first->id;
  reference.status = AlignmentStatus::reference;
  state.alignments[first->id] = reference;
  state.coverages[first->id] = {Polygon{{{0.0, 0.0}, {20.5, 0.1}, {20.0, 20.0}, {-0.25, 19.0}}}, CoverageSource::drawn};
  state.coverages[second->id] = {Polygon{{{0.0, 0.0}, {20.0, 0.0}, {10.0, 1.0 / 7.0 + 10.0}}}, CoverageSource::frames};
  state.pairs = {{first->id, second->id, 212, 205}};
  const MatchState words[] = {MatchState::automatic, MatchState::accepted, MatchState::linked, MatchState::rejected};
  for (int i = 0; i < 8; ++i) add_match(state, {first->id, i}, {second->id, i}, words[i % 4], 0.1 * i);
  state.matches.begin()->second.second_choice = StemRef{second->id, 5};
  state.matches.begin()->second.second_distance_m = 0.31;
  state.tree_of_stem[first->id] = {};
  state.tree_of_stem[second->id] = {};
  for (int i = 0; i < 12; ++i) {
    const TreeId id{i + 1};
    TreeRecord tree{id, {{first->id, i}}, std::nullopt, {}, {}};
    if (i < 8 && i % 4 != 3) tree.stems.push_back({second->id, i});
    state.tree_of_stem[first->id].push_back(id);
    state.tree_of_stem[second->id].push_back(tree.stems.size() == 2 ? id : TreeId{100 + i});
    if (tree.stems.size() == 1) state.trees[TreeId{100 + i}] = {TreeId{100 + i}, {{second->id, i}}, std::nullopt, {}, {}};
    state.trees[id] = tree;
  }
  state.trees[TreeId{2}].fate_by_hand = Fate::removed;
  state.trees[TreeId{2}].note = "stump; harvested";
  state.trees[TreeId{2}].edited_by = "anna";
  state.next_tree = 200;
  state.next_inventory = 5;
  state.georeference.kind = GeoreferenceKind::anchor;
  state.georeference.origin = {-27.61234567891234, 152.76543219876543, 105.25};
  state.georeference.anchored_point_m = {1.5, -2.25, 0.1};
  state.georeference.azimuth_deg = 12.3;
  state.georeference.sd_m = 0.35;
  state.georeference.method = "control points (4)";
  state.georeference.azimuth_sd_deg = 0.1;
  state.georeference.residuals = {{"row 2", 1.0 / 3.0, 0.4, true}, {"T-00002\tx", 7.25, std::nullopt, false}};
  state.fusion = FusionPolicy::newest;
  state.dbh_error_m[first->id] = 0.011;
  state.settings = {{"vote.cell_m", "0.5"}, {"seed", "0"}};
  state.edit_log = {{"2026-11-22T10:15:00Z", "anna", "Link 2019:1001 to T-00002", "", "T-00002", "seen twice\nsure"}, {"", "", "", "", "", ""}};
  return state;
}

ProjectState large_project(int stems, int surveys) {
  ProjectState state;
  for (int s = 0; s < surveys; ++s) {
    auto inventory = survey(s + 1, std::to_string(2000 + s), 2000 + s, stems, 5);
    InventoryAlignment a;
    a.inventory = inventory->id;
    a.status = s == 0 ? AlignmentStatus::reference : AlignmentStatus::aligned;
    state.alignments[inventory->id] = a;
    auto& trees = state.tree_of_stem[inventory->id];
    for (int i = 0; i < stems; ++i) {
      trees.push_back(TreeId{i + 1});
      if (s > 0) add_match(state, {InventoryId{s}, i}, {inventory->id, i}, MatchState::automatic, 0.05);
    }
    state.inventories.push_back(inventory);
  }
  for (int i = 0; i < stems; ++i) {
    TreeRecord tree{TreeId{i + 1}, {}, std::nullopt, {}, {}};
    for (int s = 0; s < surveys; ++s) tree.stems.push_back({InventoryId{s + 1}, i});
    state.trees[tree.id] = tree;
  }
  state.reference = InventoryId{1};
  state.next_tree = stems + 1;
  state.next_inventory = surveys + 1;
  return state;
}

}  // namespace stemwise
