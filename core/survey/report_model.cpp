#include "core/survey/drawn_ground.hpp"
#include "core/survey/report_model.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <map>
#include <numbers>

#include "core/survey/fusion_choices.hpp"

namespace stemwise {
namespace {

const char* area_source(CoverageSource source) {
  switch (source) {
    case CoverageSource::stems: return "outline of the stems";
    case CoverageSource::frames: return "what the frames saw";
    case CoverageSource::drawn: return "drawn";
  }
  return "";
}

double basal_area_sq_m(double dbh_m) { return std::numbers::pi / 4.0 * dbh_m * dbh_m; }

bool is_living(const ProjectState& state, StemRef ref) {
  const Stem* stem = state.find(ref);
  return stem == nullptr || is_living(stem->status);
}

std::optional<ReportArea> area_of(const Tables& tables, InventoryId id, const ReportOptions& options) {
  if (options.area_ha) return ReportArea{*options.area_ha, "given"};
  for (const CoverageRow& row : tables.coverages) {
    if (row.inventory == id && row.area_sq_m > 0.0) return ReportArea{row.area_sq_m / 10000.0, area_source(row.source)};
  }
  return std::nullopt;
}

ReportSurvey survey_of(const ProjectState& state, const Tables& tables, const Inventory& inventory, const ReportOptions& options) {
  ReportSurvey survey;
  survey.id = inventory.id;
  survey.name = inventory.name;
  survey.date = inventory.date;
  survey.stems = static_cast<int>(inventory.stems.size());
  survey.placed = std::find(tables.inventories.begin(), tables.inventories.end(), inventory.id) != tables.inventories.end();
  if (const auto found = state.alignments.find(inventory.id); found != state.alignments.end()) {
    const InventoryAlignment& a = found->second;
    survey.status = a.status;
    survey.reason = a.reason;
    survey.observed = a.observed;
    survey.overlap = a.overlap;
    survey.matched = a.matched;
    survey.residual_rms_m = a.residual_rms_m;
    survey.position_noise_m = a.position_noise_m;
    survey.margin = a.acceptance.margin;
    survey.probability = a.acceptance.probability;
  }
  for (const std::string& note : inventory.source.notes)
    if (note.starts_with(inventory.name + ": the trajectory")) survey.trajectory_notes.push_back(note);
  if (survey.placed) survey.area = area_of(tables, inventory.id, options);
  return survey;
}

void add_surveys(const ProjectState& state, const Tables& tables, ReportModel& model) {
  for (const InventoryId id : tables.inventories) model.surveys.push_back(survey_of(state, tables, *state.find(id), model.options));
  model.placed = model.surveys.size();
  for (const auto& inventory : state.inventories) {
    const ReportSurvey survey = survey_of(state, tables, *inventory, model.options);
    if (!survey.placed) model.surveys.push_back(survey);
  }
}

/// Index into the placed surveys of the model.
std::map<InventoryId, std::size_t> survey_index(const ReportModel& model) {
  std::map<InventoryId, std::size_t> index;
  for (std::size_t i = 0; i < model.placed; ++i) index[model.surveys[i].id] = i;
  return index;
}

ReportDbhClass& class_of(double dbh_m, ReportModel& model) {
  const double width_cm = model.options.dbh_class_width_cm;
  // A hundredth of a millimetre of slack: 0.30 m is 30 cm also where binary fractions say 29.999999999999996.
  const auto k = static_cast<std::size_t>(std::floor((dbh_m * 100.0 + 1e-6) / width_cm));
  while (model.dbh_classes.size() <= k) {
    const double low = static_cast<double>(model.dbh_classes.size()) * width_cm;
    model.dbh_classes.push_back({low, low + width_cm, std::vector<int>(model.placed), std::vector<double>(model.placed)});
  }
  return model.dbh_classes[k];
}

void drop_empty_small_classes(ReportModel& model) {
  const auto filled = std::find_if(model.dbh_classes.begin(), model.dbh_classes.end(), [](const ReportDbhClass& c) {
    return std::any_of(c.stems.begin(), c.stems.end(), [](int n) { return n > 0; });
  });
  model.dbh_classes.erase(model.dbh_classes.begin(), filled);
}

/// Stand figures and DBH classes, over every living stem of every placed survey; where its coverage was drawn, over those inside.
void count_stems(const ProjectState& state, const Tables& tables, ReportModel& model) {
  const auto index = survey_index(model);
  model.without_dbh.assign(model.placed, 0);
  std::vector<double> dbh_sum(model.placed, 0.0);
  for (const ObservationRow& row : tables.observations) {
    const auto found = index.find(row.stem.inventory);
    if (found == index.end()) continue;
    const std::size_t i = found->second;
    ReportSurvey& survey = model.surveys[i];
    if (row.dbh_error_m) survey.dbh_error_m = row.dbh_error_m;
    if (!is_living(state, row.stem)) {
      ++survey.dead;
    } else if (!model.options.area_ha && !is_on_drawn_ground(tables, survey.id, row.position_m)) {
      ++survey.beyond_area;
    } else if (!row.dbh_m || *row.dbh_m <= 0.0 || *row.dbh_m > 20.0) {
      ++model.without_dbh[i];
    } else {
      ++survey.stems_with_dbh;
      dbh_sum[i] += *row.dbh_m;
      survey.basal_area_sq_m += basal_area_sq_m(*row.dbh_m);
      ReportDbhClass& into = class_of(*row.dbh_m, model);
      ++into.stems[i];
      into.basal_area_sq_m[i] += basal_area_sq_m(*row.dbh_m);
    }
  }
  drop_empty_small_classes(model);
  for (std::size_t i = 0; i < model.placed; ++i) {
    ReportSurvey& survey = model.surveys[i];
    if (survey.stems_with_dbh == 0) continue;
    survey.mean_dbh_m = dbh_sum[i] / survey.stems_with_dbh;
    survey.quadratic_mean_dbh_m = std::sqrt(survey.basal_area_sq_m / survey.stems_with_dbh * 4.0 / std::numbers::pi);
  }
}

ReportGrowth growth_of(const Tables& tables, const GrowthRow& row, const std::map<InventoryId, std::size_t>& index) {
  ReportGrowth growth;
  growth.row = row;
  growth.from = index.at(row.from);
  growth.to = index.at(row.to);
  double basal_change = 0.0;
  for (const MatchRow& match : tables.matches) {
    if (match.state == MatchState::rejected || match.a.inventory != row.from || match.b.inventory != row.to) continue;
    ++growth.survivors;
    growth.grew += match.change == ChangeClass::grew ? 1 : 0;
    growth.shrank += match.change == ChangeClass::shrank ? 1 : 0;
    growth.within_error += match.change == ChangeClass::within_error ? 1 : 0;
    if (!match.change_m) continue;
    growth.changes_m.push_back(*match.change_m);
    basal_change += basal_area_sq_m(*match.dbh_b_m) - basal_area_sq_m(*match.dbh_a_m);
  }
  std::sort(growth.changes_m.begin(), growth.changes_m.end());
  if (!growth.changes_m.empty()) growth.basal_area_change_sq_m = basal_change;
  return growth;
}

bool is_new(Fate fate) { return fate == Fate::ingrowth || fate == Fate::missed_earlier; }
bool is_gone(Fate fate) { return fate == Fate::missing || fate == Fate::dead || fate == Fate::removed; }

/// New: the survey before looked there and had it not. Gone: it lived, the next survey looked there and has it not (who was
/// found dead there is no missing stem).
void list_new_and_missing(const ProjectState& state, const Tables& tables, ReportModel& model) {
  const auto index = survey_index(model);
  std::set<std::pair<TreeId, std::size_t>> seen;
  for (const ObservationRow& row : tables.observations)
    if (const auto found = index.find(row.stem.inventory); found != index.end()) seen.emplace(row.tree, found->second);
  for (const ObservationRow& row : tables.observations) {
    const auto found = index.find(row.stem.inventory);
    if (found == index.end()) continue;
    const Stem* stem = state.find(row.stem);
    ReportStem entry{row.tree, row.stem, row.position_m, row.dbh_m, stem == nullptr ? "" : stem->species, row.fate, found->second};
    const bool lived = stem != nullptr && is_living(stem->status);
    if (lived && is_gone(row.fate) && found->second + 1 < model.placed && !seen.contains({row.tree, found->second + 1})) model.missing_stems.push_back(entry);
    if (!row.arrival || !is_new(*row.arrival)) continue;
    entry.fate = *row.arrival;
    model.new_stems.push_back(entry);
  }
  const auto order = [](const ReportStem& a, const ReportStem& b) {
    if (a.survey != b.survey) return a.survey < b.survey;
    if (a.dbh_m.value_or(0.0) != b.dbh_m.value_or(0.0)) return a.dbh_m.value_or(0.0) > b.dbh_m.value_or(0.0);
    return a.tree < b.tree;
  };
  std::sort(model.new_stems.begin(), model.new_stems.end(), order);
  std::sort(model.missing_stems.begin(), model.missing_stems.end(), order);
  for (ReportGrowth& growth : model.growth) {
    for (const ReportStem& stem : model.new_stems) growth.new_stems += stem.survey == growth.to ? 1 : 0;
    for (const ReportStem& stem : model.missing_stems) growth.missing_stems += stem.survey == growth.from ? 1 : 0;
  }
}

int decided_by_hand(const ProjectState& state) {
  return static_cast<int>(std::count_if(state.matches.begin(), state.matches.end(),
                                        [](const auto& entry) { return entry.second.state != MatchState::automatic; }));
}

std::string georeference_text(const Georeference& georeference) {
  return georeference.kind == GeoreferenceKind::none ? "" : georeference.method;
}

void describe_georeference(const Georeference& georeference, ReportModel& model) {
  model.georeference = georeference_text(georeference);
  model.height_datum = georeference.geoid.name.empty() ? "the ellipsoid" : "the geoid " + georeference.geoid.name;
  model.georeference_sd_m = georeference.sd_m;
  model.georeference_residuals = georeference.residuals;
  constexpr double quarter = std::numbers::pi / 2.0;
  if (georeference.kind == GeoreferenceKind::anchor) model.north_rad = quarter + georeference.azimuth_deg * std::numbers::pi / 180.0;
  if (georeference.kind == GeoreferenceKind::crs) model.north_rad = quarter;
}

void add_rules(const std::vector<RuleCount>& counts, const std::string& pack, bool is_chosen, ReportModel& model) {
  for (const RuleCount& count : counts) model.rules.push_back({pack, count, is_chosen});
}

std::string rule_flags(const MatchRow& match, const RulePack& pack) {
  std::string text;
  for (const Rule& rule : pack.rules)
    if (std::find(match.flags.begin(), match.flags.end(), rule.flag) != match.flags.end()) text += (text.empty() ? "" : "; ") + rule.flag;
  return text;
}

void judge_growth(const ProjectState& state, const Tables& tables, ReportModel& model) {
  const std::optional<RulePack> chosen = chosen_rules(state);
  if (chosen) {
    model.rule_pack = chosen->name;
    add_rules(count_broken(*chosen, tables), chosen->name, true, model);
  }
  for (const RulePack& pack : rule_packs())
    if (!chosen || pack.name != chosen->name) add_rules(count_broken(pack, tables), pack.name, false, model);
  if (!chosen) return;
  const auto index = survey_index(model);
  for (const MatchRow& match : tables.matches) {
    const std::string flags = rule_flags(match, *chosen);
    if (flags.empty()) continue;
    const TreeRow* tree = tables.find(match.tree);
    model.flagged.push_back({match.tree, index.at(match.a.inventory), index.at(match.b.inventory), *match.dbh_a_m, *match.dbh_b_m, match.growth_m_per_year, flags,
                             tree == nullptr ? "" : tree->species});
  }
  std::stable_sort(model.flagged.begin(), model.flagged.end(), [](const ReportFlagged& a, const ReportFlagged& b) {
    return std::abs(a.later_dbh_m - a.earlier_dbh_m) > std::abs(b.later_dbh_m - b.earlier_dbh_m);
  });
}

}  // namespace

ReportModel make_report_model(const ProjectState& state, const Tables& tables, const ReportOptions& options) {
  ReportModel model;
  model.title = state.title;
  model.options = options;
  model.fusion = state.fusion;
  describe_georeference(state.georeference, model);
  model.settings = state.settings;
  if (const Inventory* reference = state.find(state.reference)) model.reference = reference->name;
  model.trees_by_fate = tables.trees_by_fate;
  model.trees = tables.trees;
  model.decisions_by_hand = decided_by_hand(state);
  add_surveys(state, tables, model);
  count_stems(state, tables, model);
  const auto index = survey_index(model);
  for (const GrowthRow& row : tables.growth) {
    if (index.contains(row.from) && index.contains(row.to)) model.growth.push_back(growth_of(tables, row, index));
  }
  model.stand_growth = stand_growth(state, tables);
  model.growth_groups = growth_groups(state, tables, options.dbh_class_width_cm);
  model.changes = stand_changes(state, tables, {options.area_ha, options.dbh_class_width_cm});
  model.conflicts = fusion_conflicts(state, tables);
  model.chosen_by_hand = static_cast<int>(fusion_choices(state).size());
  model.ground = observed_ground(tables);
  list_new_and_missing(state, tables, model);
  judge_growth(state, tables, model);
  return model;
}

}  // namespace stemwise
