#include "core/survey/rule_pack.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

namespace stemwise {
namespace {

Rule growth_rule(std::string flag, std::string meaning, double limit_m_per_year) {
  Rule rule;
  rule.flag = std::move(flag);
  rule.meaning = std::move(meaning);
  rule.growth_above_m_per_year = limit_m_per_year;
  return rule;
}

/// Condit (2012), CTFS R package, trim.growth: standard deviation of one DBH in Barro Colorado's remeasured stems.
constexpr SdLimit ctfs_sd{0.006214, 0.0009036, 4.0};

RulePack ctfs() {
  Rule shrinkage;
  shrinkage.flag = "ctfs_shrinkage";
  shrinkage.meaning = "later DBH more than 4 standard deviations below the earlier (sd = 0.006214 dbh + 0.9036 mm); CTFS trim.growth";
  shrinkage.shrinkage_beyond = ctfs_sd;
  return {"ctfs", "CTFS trim.growth", {shrinkage, growth_rule("ctfs_growth", "growth above 75 mm a year; CTFS trim.growth", 0.075)}};
}

RulePack forestgeo() {
  Rule growth = growth_rule("forestgeo_growth", "growth above 65 mm a year, both DBHs at least 10 mm; ForestGEO", 0.065);
  growth.least_dbh_m = 0.010;
  Rule shrinkage;
  shrinkage.flag = "forestgeo_shrinkage";
  shrinkage.meaning = "shrank by 5 % of the earlier DBH a year or more, both DBHs at least 10 mm; ForestGEO";
  shrinkage.shrinkage_share_per_year = 0.05;
  shrinkage.least_dbh_m = 0.010;
  return {"forestgeo", "ForestGEO", {growth, shrinkage}};
}

RulePack scbi() {
  Rule shrinkage, growth;
  shrinkage.flag = "scbi_shrinkage";
  shrinkage.meaning = "later DBH below 0.75 of the earlier (of the pair, not a year); SCBI field check";
  shrinkage.ratio_below = 0.75;
  growth.flag = "scbi_growth";
  growth.meaning = "later DBH above 1.92 of the earlier (of the pair, not a year); SCBI field check";
  growth.ratio_above = 1.92;
  return {"scbi", "SCBI field check", {shrinkage, growth}};
}

RulePack treedata() {
  Rule growth, pioneers, shrinkage;
  growth.flag = "treedata_growth";
  growth.meaning = "growth of 5 cm a year or more, species that are no pioneers; TreeData";
  growth.growth_at_least_m_per_year = 0.05;
  growth.not_species = {"Cecropia", "Pourouma"};
  pioneers.flag = "treedata_growth_pioneer";
  pioneers.meaning = "growth of 7.5 cm a year or more, pioneers (Cecropia, Pourouma); TreeData";
  pioneers.growth_at_least_m_per_year = 0.075;
  pioneers.species = growth.not_species;
  shrinkage.flag = "treedata_shrinkage";
  shrinkage.meaning = "lost more than 2 cm (of the pair, not a year); TreeData";
  shrinkage.change_below_m = -0.02;
  return {"treedata", "TreeData", {growth, pioneers, shrinkage}};
}

RulePack lidar() {
  Rule growth = growth_rule("lidar_growth", "growth above 75 mm a year by more than 4 standard errors of the two surveys' DBHs", 0.075);
  growth.error_sigmas = 4.0;
  Rule shrinkage;
  shrinkage.flag = "lidar_shrinkage";
  shrinkage.meaning = "shrank by more than 4 standard deviations: CTFS's of one DBH and the two surveys' DBH errors together";
  shrinkage.shrinkage_beyond = ctfs_sd;
  shrinkage.error_sigmas = 4.0;
  return {"lidar", "CTFS, widened by the surveys' DBH errors", {growth, shrinkage}};
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_among(const std::string& species, const std::vector<std::string>& names) {
  const std::string name = lower(species);
  return std::any_of(names.begin(), names.end(), [&](const std::string& one) { return !one.empty() && name.starts_with(lower(one)); });
}

bool grew_too_much(const Rule& rule, double change_m, double margin_m, double years) {
  const double rate = (change_m - margin_m) / years;
  return (rule.growth_above_m_per_year && rate > *rule.growth_above_m_per_year) || (rule.growth_at_least_m_per_year && rate >= *rule.growth_at_least_m_per_year);
}

bool shrank_too_much(const Rule& rule, const RuleCase& pair, double change_m, double error_m) {
  const double margin_m = rule.error_sigmas * error_m;
  if (rule.change_below_m && change_m + margin_m < *rule.change_below_m) return true;
  if (rule.ratio_below && pair.later_dbh_m + margin_m < *rule.ratio_below * pair.earlier_dbh_m) return true;
  if (rule.shrinkage_share_per_year && pair.years && -(change_m + margin_m) / pair.earlier_dbh_m / *pair.years >= *rule.shrinkage_share_per_year) return true;
  if (!rule.shrinkage_beyond) return false;
  const SdLimit& limit = *rule.shrinkage_beyond;
  double sd_m = limit.slope * pair.earlier_dbh_m + limit.intercept_m;
  if (rule.error_sigmas > 0.0) sd_m = std::hypot(sd_m, error_m);
  return change_m <= -limit.times * sd_m;
}

/// Every number of a rule with its key and the factor from the text's unit to ours.
template <class R>
auto number_fields(R& rule) {
  using Optional = std::conditional_t<std::is_const_v<R>, const std::optional<double>*, std::optional<double>*>;
  struct Field {
    const char* key;
    Optional value;
    double factor;
  };
  return std::vector<Field>{{"growth_above_cm_per_year", &rule.growth_above_m_per_year, 0.01}, {"growth_at_least_cm_per_year", &rule.growth_at_least_m_per_year, 0.01},
                            {"change_below_cm", &rule.change_below_m, 0.01},                   {"ratio_below", &rule.ratio_below, 1.0},
                            {"ratio_above", &rule.ratio_above, 1.0},                           {"shrinkage_percent_per_year", &rule.shrinkage_share_per_year, 0.01}};
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(at, from), text.size());
    if (to > from) parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ",") + part;
  return text;
}

std::optional<double> number_of(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string text_of(double value) {
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

Result<Rule> refused(const std::string& text) {
  return Result<Rule>::failure(Issue{Severity::error, "", 0, "", text, "docs/rules.md names every key of a rule"});
}

/// Sets one key; false when there is no such key. Numbers were read before.
bool set_number(Rule& rule, const std::string& key, double value) {
  for (const auto& field : number_fields(rule)) {
    if (key != field.key) continue;
    *field.value = value * field.factor;
    return true;
  }
  if (key == "error_sigmas") rule.error_sigmas = value;
  else if (key == "least_dbh_cm") rule.least_dbh_m = value * 0.01;
  else if (key == "sd_slope" || key == "sd_intercept_cm" || key == "sd_times") {
    if (!rule.shrinkage_beyond) rule.shrinkage_beyond.emplace();
    (key == "sd_slope" ? rule.shrinkage_beyond->slope : key == "sd_times" ? rule.shrinkage_beyond->times : rule.shrinkage_beyond->intercept_m) =
        key == "sd_intercept_cm" ? value * 0.01 : value;
  } else return false;
  return true;
}

bool has_limit(const Rule& rule) {
  const auto fields = number_fields(rule);
  return rule.shrinkage_beyond || std::any_of(fields.begin(), fields.end(), [](const auto& f) { return f.value->has_value(); });
}

constexpr const char* pack_key = "rules.pack";
constexpr const char* own_key = "rules.own";

/// Of every match that a rule can look at: its case.
class Cases {
 public:
  explicit Cases(const Tables& tables) {
    for (const ObservationRow& row : tables.observations)
      if (row.dbh_error_m) error_m_[row.stem.inventory] = *row.dbh_error_m;
    for (const TreeRow& tree : tables.trees) species_[tree.tree] = tree.species;
  }
  std::optional<RuleCase> of(const MatchRow& match) const {
    if (match.state == MatchState::rejected || !match.dbh_a_m || !match.dbh_b_m || *match.dbh_a_m <= 0.0) return std::nullopt;
    const auto species = species_.find(match.tree);
    return RuleCase{*match.dbh_a_m, *match.dbh_b_m, match.years, error_of(match.a.inventory), error_of(match.b.inventory), species == species_.end() ? "" : species->second};
  }

 private:
  double error_of(InventoryId id) const {
    const auto found = error_m_.find(id);
    return found == error_m_.end() ? 0.0 : found->second;
  }
  std::map<InventoryId, double> error_m_;
  std::map<TreeId, std::string> species_;
};

}  // namespace

Verdict judge(const Rule& rule, const RuleCase& pair) {
  if (pair.earlier_dbh_m <= 0.0 || std::min(pair.earlier_dbh_m, pair.later_dbh_m) < rule.least_dbh_m) return Verdict::not_judged;
  if (!rule.species.empty() && !is_among(pair.species, rule.species)) return Verdict::not_judged;
  if (is_among(pair.species, rule.not_species)) return Verdict::not_judged;
  const double change_m = pair.later_dbh_m - pair.earlier_dbh_m;
  const double error_m = std::hypot(pair.earlier_error_m, pair.later_error_m);
  const bool dated = pair.years && *pair.years > 0.0;
  if (shrank_too_much(rule, pair, change_m, error_m)) return Verdict::broken;
  if (rule.ratio_above && pair.later_dbh_m - rule.error_sigmas * error_m > *rule.ratio_above * pair.earlier_dbh_m) return Verdict::broken;
  const bool by_year = rule.growth_above_m_per_year || rule.growth_at_least_m_per_year || rule.shrinkage_share_per_year;
  if (by_year && !dated) return Verdict::not_judged;
  if (dated && grew_too_much(rule, change_m, rule.error_sigmas * error_m, *pair.years)) return Verdict::broken;
  return Verdict::fine;
}

const std::vector<RulePack>& rule_packs() {
  static const std::vector<RulePack> packs{ctfs(), forestgeo(), scbi(), treedata(), lidar()};
  return packs;
}

const RulePack* find_rule_pack(const std::string& name) {
  const auto& packs = rule_packs();
  const auto found = std::find_if(packs.begin(), packs.end(), [&](const RulePack& pack) { return pack.name == name; });
  return found == packs.end() ? nullptr : &*found;
}

Result<Rule> rule_from_text(const std::string& text) {
  Rule rule;
  for (const std::string& part : split(text, ';')) {
    const std::size_t equals = part.find('=');
    const std::string key = part.substr(0, equals), value = equals == std::string::npos ? "" : part.substr(equals + 1);
    if (key == "flag") rule.flag = value;
    else if (key == "meaning") rule.meaning = value;
    else if (key == "species") rule.species = split(value, ',');
    else if (key == "not_species") rule.not_species = split(value, ',');
    else {
      const auto number = number_of(value);
      if (!number) return refused("'" + value + "' is no number for " + key);
      if (!set_number(rule, key, *number)) return refused("'" + key + "' is no key of a rule");
    }
  }
  if (rule.flag.empty() || rule.flag.find_first_of("; ,\t\n") != std::string::npos) return refused("a rule needs a flag of one word");
  if (!has_limit(rule)) return refused("the rule " + rule.flag + " has no limit");
  return rule;
}

std::string to_text(const Rule& rule) {
  std::string meaning = rule.meaning;
  std::replace(meaning.begin(), meaning.end(), ';', ',');
  std::replace(meaning.begin(), meaning.end(), '\n', ' ');
  std::string text = "flag=" + rule.flag + (meaning.empty() ? "" : ";meaning=" + meaning);
  for (const auto& field : number_fields(rule))
    if (*field.value) text += std::string(";") + field.key + "=" + text_of(**field.value / field.factor);
  if (rule.shrinkage_beyond)
    text += ";sd_slope=" + text_of(rule.shrinkage_beyond->slope) + ";sd_intercept_cm=" + text_of(rule.shrinkage_beyond->intercept_m * 100.0) +
            ";sd_times=" + text_of(rule.shrinkage_beyond->times);
  if (rule.error_sigmas != 0.0) text += ";error_sigmas=" + text_of(rule.error_sigmas);
  if (rule.least_dbh_m != 0.0) text += ";least_dbh_cm=" + text_of(rule.least_dbh_m * 100.0);
  if (!rule.species.empty()) text += ";species=" + joined(rule.species);
  if (!rule.not_species.empty()) text += ";not_species=" + joined(rule.not_species);
  return text;
}

std::optional<RulePack> chosen_rules(const ProjectState& state) {
  const auto name = state.settings.find(pack_key);
  if (name == state.settings.end() || name->second.empty()) return std::nullopt;
  const auto own = state.settings.find(own_key);
  if (own == state.settings.end() || own->second.empty()) {
    const RulePack* pack = find_rule_pack(name->second);
    return pack == nullptr ? std::nullopt : std::optional(*pack);
  }
  RulePack pack{name->second, "own rules", {}};
  for (const std::string& line : split(own->second, '\n'))
    if (auto rule = rule_from_text(line)) pack.rules.push_back(*rule);
  return pack;
}

std::vector<std::pair<std::string, std::string>> settings_of(const std::optional<RulePack>& pack) {
  if (!pack) return {{pack_key, ""}, {own_key, ""}};
  std::string own;
  if (find_rule_pack(pack->name) == nullptr)
    for (const Rule& rule : pack->rules) own += to_text(rule) + "\n";
  return {{pack_key, pack->name}, {own_key, own}};
}

std::vector<RuleCount> count_broken(const RulePack& pack, const Tables& tables) {
  const Cases cases(tables);
  std::vector<RuleCount> counts;
  for (const Rule& rule : pack.rules) {
    RuleCount count{rule.flag, rule.meaning, 0, 0};
    for (const MatchRow& match : tables.matches) {
      const auto pair = cases.of(match);
      const Verdict verdict = pair ? judge(rule, *pair) : Verdict::not_judged;
      count.broken += verdict == Verdict::broken ? 1 : 0;
      count.judged += verdict != Verdict::not_judged ? 1 : 0;
    }
    counts.push_back(std::move(count));
  }
  return counts;
}

void flag_implausible(const ProjectState& state, Tables& tables) {
  const std::optional<RulePack> pack = chosen_rules(state);
  if (!pack) return;
  const Cases cases(tables);
  for (MatchRow& match : tables.matches) {
    const auto pair = cases.of(match);
    if (!pair) continue;
    for (const Rule& rule : pack->rules) {
      if (judge(rule, *pair) != Verdict::broken) continue;
      match.flags.push_back(rule.flag);
      const auto tree = std::lower_bound(tables.trees.begin(), tables.trees.end(), match.tree, [](const TreeRow& row, TreeId id) { return row.tree < id; });
      if (tree == tables.trees.end() || tree->tree != match.tree) continue;
      if (std::find(tree->flags.begin(), tree->flags.end(), rule.flag) == tree->flags.end()) tree->flags.push_back(rule.flag);
    }
  }
}

}  // namespace stemwise
