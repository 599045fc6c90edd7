#include "core/survey/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <unordered_map>

#include "core/base/quantile.hpp"
#include "core/survey/decide_fate.hpp"
#include "core/survey/fuse_tree.hpp"
#include "core/survey/growth.hpp"
#include "core/survey/place_coverage.hpp"
#include "core/survey/review_queue.hpp"
#include "core/survey/rule_pack.hpp"

namespace stemwise {
namespace {

constexpr std::array<const char*, 4> change_words{"grew", "shrank", "within_error", "unknown"};
constexpr double assumed_dbh_error_m = 0.01;  // field crews: +-1 cm (data/README.md); until enough stems are matched
constexpr double assumed_noise_m = 0.1;

/// One placed survey and what every row needs of it.
struct Survey {
  const Inventory* inventory = nullptr;
  RigidTransform reference_from_inventory;
  double noise_m = assumed_noise_m;
  std::optional<double> dbh_error_m;
  SurveyFootprint footprint;
};

struct TreeSightings {
  const TreeRecord* record = nullptr;
  std::vector<Sighting> by_date;
};

/// Of a dead stem no growth is told: bark falls, wood dries.
bool is_living(const Sighting& sighting) { return is_living(sighting.stem->status); }

/// More than any tree grows (TreeData's limit for pioneers is 7.5 cm a year): another stem, or a diameter mismeasured.
bool is_implausible(const MatchRow& row) {
  constexpr double most_m_per_year = 0.075, most_undated_m = 0.25;
  if (!row.change_m || row.change != ChangeClass::grew) return false;
  return row.growth_m_per_year ? *row.growth_m_per_year > most_m_per_year : *row.change_m > most_undated_m;
}

double smallest_dbh_m(const Inventory& inventory) {
  std::vector<double> dbh;
  for (const Stem& stem : inventory.stems)
    if (stem.dbh_m) dbh.push_back(*stem.dbh_m);
  if (dbh.empty()) return 0.0;
  std::sort(dbh.begin(), dbh.end());
  return quantile_of_sorted(dbh, 0.02);
}

/// An outline that follows a list's stems is off by as much as these stand apart: three quarters of their typical spacing, which is 0.55
/// of the side of a stem's share of the ground (coverage.hpp).
double outline_doubt_m(const CoverageRow& coverage, std::size_t stems) {
  if (coverage.source != CoverageSource::stems || stems == 0) return 0.0;
  return 0.75 * 0.55 * std::sqrt(coverage.area_sq_m / static_cast<double>(stems));
}

/// Derives the tables step by step; only `derive_tables` sees it.
class Derivation {
 public:
  explicit Derivation(const ProjectState& state) : state_(state) {}

  Tables run() {
    place_surveys();
    collect_sightings();
    derive_growth();
    derive_matches();
    derive_trees();
    derive_observations();
    tables_.queue = review_queue(state_, tables_);
    return std::move(tables_);
  }

 private:
  void place_surveys();
  void collect_sightings();
  void derive_growth();
  void derive_matches();
  void set_growth(TreeRow& row, const Sighting& first, const Sighting& last) const;
  void derive_trees();
  void derive_observations();

  MatchRow match_row(const TreeSightings& tree, const Sighting& a, const Sighting& b) const;
  void add_rejected();
  std::optional<double> years_between_stems(const Sighting& a, const Sighting& b) const;
  double dbh_error_m(std::size_t survey) const { return surveys_[survey].dbh_error_m.value_or(assumed_dbh_error_m); }
  double most_growth_m(std::size_t from) const;
  Fate fate_at(const TreeSightings& tree, const TreeRow& row, std::size_t from) const;
  std::size_t survey_of(InventoryId id) const { return index_.at(id); }

  const ProjectState& state_;
  Tables tables_;
  std::vector<Survey> surveys_;
  std::unordered_map<InventoryId, std::size_t> index_;
  std::vector<TreeSightings> trees_;
  std::vector<std::vector<double>> sorted_changes_m_;  // per step between consecutive surveys
};

void Derivation::place_surveys() {
  for (const InventoryId id : state_.by_date()) {
    if (!state_.is_placed(id)) continue;
    Survey survey;
    survey.inventory = state_.find(id);
    survey.reference_from_inventory = state_.reference_from_inventory(id);
    if (const auto a = state_.alignments.find(id); a != state_.alignments.end() && a->second.position_noise_m > 0.0)
      survey.noise_m = a->second.position_noise_m;
    if (const auto e = state_.dbh_error_m.find(id); e != state_.dbh_error_m.end()) survey.dbh_error_m = e->second;
    survey.footprint = {id, {}, survey.noise_m, 0.0, smallest_dbh_m(*survey.inventory)};
    if (const auto c = state_.coverages.find(id); c != state_.coverages.end()) {
      survey.footprint.coverage_in_reference = place_coverage(c->second.in_inventory, *survey.inventory, survey.reference_from_inventory);
      tables_.coverages.push_back({id, survey.footprint.coverage_in_reference,
                                   area_sq_m(survey.footprint.coverage_in_reference), c->second.source});
      survey.footprint.outline_doubt_m = outline_doubt_m(tables_.coverages.back(), survey.inventory->stems.size());
    }
    index_[id] = surveys_.size();
    tables_.inventories.push_back(id);
    surveys_.push_back(std::move(survey));
  }
}

void Derivation::collect_sightings() {
  trees_.reserve(state_.trees.size());
  for (const auto& [id, record] : state_.trees) {
    TreeSightings tree{&record, {}};
    for (const StemRef& ref : record.stems) {
      const Survey& survey = surveys_[survey_of(ref.inventory)];
      Sighting sighting;
      sighting.ref = ref;
      sighting.stem = &survey.inventory->stems[static_cast<std::size_t>(ref.index)];
      const Stem& stem = *sighting.stem;
      sighting.position_m = survey.reference_from_inventory * Eigen::Vector3d(stem.x_m, stem.y_m, stem.z_m.value_or(0.0));
      if (stem.axis) sighting.axis = survey.reference_from_inventory.rotation * *stem.axis;
      sighting.position_sd_m = survey.noise_m;
      tree.by_date.push_back(sighting);
    }
    std::sort(tree.by_date.begin(), tree.by_date.end(),
              [&](const Sighting& a, const Sighting& b) { return survey_of(a.ref.inventory) < survey_of(b.ref.inventory); });
    trees_.push_back(std::move(tree));
  }
}

std::optional<double> Derivation::years_between_stems(const Sighting& a, const Sighting& b) const {
  const auto date_of = [&](const Sighting& s) {
    return s.stem->date ? s.stem->date : surveys_[survey_of(s.ref.inventory)].inventory->date;
  };
  const auto from = date_of(a), to = date_of(b);
  if (!from || !to || *to <= *from) return std::nullopt;
  return years_between(*from, *to);
}

void Derivation::derive_growth() {
  if (surveys_.size() < 2) return;
  std::vector<std::vector<DbhPair>> pairs(surveys_.size() - 1);
  for (const TreeSightings& tree : trees_)
    for (std::size_t i = 1; i < tree.by_date.size(); ++i) {
      const Sighting &a = tree.by_date[i - 1], &b = tree.by_date[i];
      const std::size_t from = survey_of(a.ref.inventory);
      if (survey_of(b.ref.inventory) != from + 1 || !a.stem->dbh_m || !b.stem->dbh_m || !is_living(a) || !is_living(b)) continue;
      pairs[from].push_back({*a.stem->dbh_m, *b.stem->dbh_m, years_between_stems(a, b)});
    }
  std::vector<std::vector<double>> errors(surveys_.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto from = surveys_[i].inventory->date, to = surveys_[i + 1].inventory->date;
    const auto years = from && to && *to > *from ? std::optional(years_between(*from, *to)) : std::nullopt;
    tables_.growth.push_back(growth_between(surveys_[i].inventory->id, surveys_[i + 1].inventory->id, years, pairs[i]));
    std::vector<double> changes;
    for (const DbhPair& pair : pairs[i]) changes.push_back(pair.later_m - pair.earlier_m);
    std::sort(changes.begin(), changes.end());
    sorted_changes_m_.push_back(std::move(changes));
    if (pairs[i].size() >= 8) {
      errors[i].push_back(tables_.growth.back().dbh_error_m);
      errors[i + 1].push_back(tables_.growth.back().dbh_error_m);
    }
  }
  for (std::size_t i = 0; i < surveys_.size(); ++i)
    if (!surveys_[i].dbh_error_m && !errors[i].empty()) surveys_[i].dbh_error_m = *std::min_element(errors[i].begin(), errors[i].end());
}

double Derivation::most_growth_m(std::size_t from) const {
  const std::vector<double>& changes = sorted_changes_m_[from];
  const double error_m = 2.0 * dbh_error_m(from + 1);
  const double years = tables_.growth[from].years.value_or(5.0);
  const double most = changes.size() >= 8 ? quantile_of_sorted(changes, 0.95) : 0.01 * years;
  return std::max(0.005, most) + error_m;
}

MatchRow Derivation::match_row(const TreeSightings& tree, const Sighting& a, const Sighting& b) const {
  MatchRow row;
  row.tree = tree.record->id;
  row.a = a.ref;
  row.b = b.ref;
  row.distance_m = (a.position_m - b.position_m).head<2>().norm();
  row.dbh_a_m = a.stem->dbh_m;
  row.dbh_b_m = b.stem->dbh_m;
  row.years = years_between_stems(a, b);
  const bool measured = row.dbh_a_m && row.dbh_b_m;
  if (measured && is_living(a) && is_living(b)) row.change_m = *row.dbh_b_m - *row.dbh_a_m;  // what a dead stem measures is no growth
  if (row.change_m && row.years) row.growth_m_per_year = *row.change_m / *row.years;
  row.change = classify_change(row.change_m, dbh_error_m(survey_of(a.ref.inventory)), dbh_error_m(survey_of(b.ref.inventory)));
  const auto found = state_.matches.find(ordered(a.ref, b.ref));
  row.confidence = 0.5;  // joined through a third survey only
  if (found != state_.matches.end()) {
    row.confidence = found->second.confidence;
    row.state = found->second.state;
    row.second_distance_m = found->second.second_distance_m;
  }
  if (row.state == MatchState::linked || row.state == MatchState::accepted) row.confidence = 1.0;
  if (row.change == ChangeClass::shrank) row.flags.push_back("shrinkage");
  if (is_implausible(row)) row.flags.push_back("implausible_growth");
  if (!measured) row.flags.push_back("no_dbh");
  if (!is_living(a) && is_living(b)) row.flags.push_back("alive_after_dead");
  return row;
}

void Derivation::derive_matches() {
  for (const TreeSightings& tree : trees_)
    for (std::size_t i = 1; i < tree.by_date.size(); ++i)
      tables_.matches.push_back(match_row(tree, tree.by_date[i - 1], tree.by_date[i]));
  add_rejected();
}

/// The pairs that a person took apart, so that the decision can be seen and taken back.
void Derivation::add_rejected() {
  std::map<std::pair<TreeId, StemRef>, MatchRow> last;  // of the stems that were one tree, the nearest in time before: consecutive sightings
  for (const auto& [key, match] : state_.matches) {
    if (match.joins() || !index_.contains(match.a.inventory) || !index_.contains(match.b.inventory)) continue;
    const bool in_order = survey_of(match.a.inventory) <= survey_of(match.b.inventory);
    const StemRef first = in_order ? match.a : match.b, second = in_order ? match.b : match.a;
    const auto sighting = [&](StemRef ref) {
      return Sighting{ref, state_.find(ref), state_.stem_in_reference_m(ref), std::nullopt, 0.0, 0.0};
    };
    const auto record = state_.trees.find(state_.tree_of(first));
    if (record == state_.trees.end()) continue;
    const MatchRow row = match_row({&record->second, {}}, sighting(first), sighting(second));
    const auto [place, is_new] = last.try_emplace({row.tree, row.b}, row);
    if (!is_new && survey_of(place->second.a.inventory) < survey_of(row.a.inventory)) place->second = row;
  }
  for (const auto& entry : last) tables_.matches.push_back(entry.second);
}

Fate Derivation::fate_at(const TreeSightings& tree, const TreeRow& row, std::size_t from) const {
  SurveyStep step{&surveys_[from].footprint, &surveys_[from + 1].footprint, most_growth_m(from)};
  TreeAtStep at;
  at.position_in_reference_m = row.position_m.head<2>();
  at.by_hand = tree.record->fate_by_hand;
  for (const Sighting& s : tree.by_date) {
    const std::size_t survey = survey_of(s.ref.inventory);
    if (survey < from) at.seen_earlier = true;
    if (survey <= from) at.code_before = s.stem->status;
    if (survey == from) at.seen_from = true;
    if (survey > from + 1) at.seen_later = true;
    if (survey != from + 1) continue;
    at.seen_to = true;
    at.code_in_to = s.stem->status;
    at.dbh_in_to_m = s.stem->dbh_for_matching_m();
  }
  // A fate said by hand is about the step at which the tree was last there; before that it lived on.
  if (at.by_hand && at.seen_from && at.seen_to && from + 2 < surveys_.size()) at.by_hand.reset();
  return decide_fate(step, at);
}

/// Over the whole time that the tree was measured alive.
void Derivation::set_growth(TreeRow& row, const Sighting& first, const Sighting& last) const {
  const double change_m = *last.stem->dbh_m - *first.stem->dbh_m;
  row.growth_from = first.ref.inventory;
  row.growth_to = last.ref.inventory;
  row.growth = classify_change(change_m, first.dbh_error_m, last.dbh_error_m);
  if (const auto years = years_between_stems(first, last)) row.growth_m_per_year = change_m / *years;
}

void Derivation::derive_trees() {
  std::unordered_map<TreeId, double> weakest;
  for (const MatchRow& match : tables_.matches)
    if (match.state != MatchState::rejected) {
      const auto [place, is_new] = weakest.try_emplace(match.tree, match.confidence);
      if (!is_new) place->second = std::min(place->second, match.confidence);
    }
  const auto choices = fusion_choices(state_);
  for (TreeSightings& tree : trees_) {
    for (Sighting& s : tree.by_date) s.dbh_error_m = dbh_error_m(survey_of(s.ref.inventory));
    const auto choice = choices.find(tree.record->id);
    TreeRow row = fuse_tree(tree.record->id, tree.by_date, state_.fusion, choice == choices.end() ? FusionChoice{} : choice->second);
    row.note = tree.record->note;
    row.edited_by = tree.record->edited_by;
    row.dbh_per_inventory_m.resize(surveys_.size());
    const Sighting* first = nullptr;
    const Sighting* last = nullptr;
    for (const Sighting& s : tree.by_date) {
      row.dbh_per_inventory_m[survey_of(s.ref.inventory)] = s.stem->dbh_m;
      if (!s.stem->dbh_m || !is_living(s)) continue;
      if (first == nullptr) first = &s;
      last = &s;
    }
    if (first != nullptr && first != last) set_growth(row, *first, *last);
    if (!row.dbh_m) row.flags.push_back("no_dbh");
    if (const auto found = weakest.find(row.tree); found != weakest.end()) row.confidence = found->second;
    if (surveys_.size() >= 2) row.fate = fate_at(tree, row, surveys_.size() - 2);
    ++tables_.trees_by_fate[static_cast<std::size_t>(row.fate)];
    tables_.trees.push_back(std::move(row));
  }
}

void Derivation::derive_observations() {
  for (std::size_t t = 0; t < trees_.size(); ++t) {
    const TreeRow& tree = tables_.trees[t];
    for (const Sighting& s : trees_[t].by_date) {
      ObservationRow row;
      const std::size_t survey = survey_of(s.ref.inventory);
      row.tree = tree.tree;
      row.stem = s.ref;
      row.position_m = s.position_m;
      row.has_z = s.stem->z_m.has_value();
      row.dbh_m = s.stem->dbh_m;
      if (row.dbh_m) row.dbh_error_m = dbh_error_m(survey);
      if (surveys_.size() >= 2) row.fate = fate_at(trees_[t], tree, std::min(survey, surveys_.size() - 2));
      if (survey > 0) row.arrival = fate_at(trees_[t], tree, survey - 1);
      if (tree.times_seen > 1) {
        row.residual_m = (s.position_m - tree.position_m).head<2>().norm();
        row.confidence = tree.confidence;
      }
      if (!s.stem->dbh_m && s.stem->dbh_approximation_m) row.flags.push_back("dbh_approximate");
      tables_.observations.push_back(std::move(row));
    }
  }
  std::stable_sort(tables_.observations.begin(), tables_.observations.end(), [&](const ObservationRow& a, const ObservationRow& b) {
    const std::size_t i = survey_of(a.stem.inventory), j = survey_of(b.stem.inventory);
    return i != j ? i < j : a.stem.index < b.stem.index;
  });
}

}  // namespace

const char* to_string(ChangeClass change) { return change_words[static_cast<std::size_t>(change)]; }

std::string tree_label(TreeId id) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "T-%05lld", static_cast<long long>(id.value));
  return buffer.data();
}

const TreeRow* Tables::find(TreeId id) const {
  const auto found = std::lower_bound(trees.begin(), trees.end(), id, [](const TreeRow& row, TreeId wanted) { return row.tree < wanted; });
  return found == trees.end() || found->tree != id ? nullptr : &*found;
}

Tables derive_tables(const ProjectState& state) {
  Tables tables = Derivation(state).run();
  flag_implausible(state, tables);
  return tables;
}

}  // namespace stemwise
