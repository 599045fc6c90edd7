#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {

// Named packs of rules for growth that nobody believes (product.md, item 7). They flag; they never delete. Lengths in metres.

/// A limit that grows with the diameter: `times` standard deviations of slope * dbh + intercept.
struct SdLimit {
  double slope = 0.0;
  double intercept_m = 0.0;
  double times = 4.0;
};

/// One rule: broken when any of its limits is. What is not set is no limit.
struct Rule {
  std::string flag;      ///< one word: what stands in the flags columns
  std::string meaning;   ///< one sentence with its figures and source
  std::optional<double> growth_above_m_per_year;
  std::optional<double> growth_at_least_m_per_year;
  std::optional<double> change_below_m;               ///< of the pair, not a year
  std::optional<double> ratio_below, ratio_above;     ///< later over earlier DBH
  std::optional<double> shrinkage_share_per_year;     ///< at least this share of the earlier DBH a year
  std::optional<SdLimit> shrinkage_beyond;            ///< lost more than so many standard deviations of one measurement
  double error_sigmas = 0.0;    ///< every limit is widened by so many standard errors of the difference of the two surveys' DBHs
  double least_dbh_m = 0.0;     ///< both DBHs are at least this, or the rule says nothing
  std::vector<std::string> species;      ///< only these (beginnings of names, case does not matter); empty: all
  std::vector<std::string> not_species;  ///< all but these
};

struct RulePack {
  std::string name;
  std::string title;
  std::vector<Rule> rules;
};

/// What a rule looks at: two measured diameters of one tree.
struct RuleCase {
  double earlier_dbh_m = 0.0, later_dbh_m = 0.0;
  std::optional<double> years;
  double earlier_error_m = 0.0, later_error_m = 0.0;
  std::string species;
};

enum class Verdict { fine, broken, not_judged };  ///< not judged: too small, another species, or the years are not known
Verdict judge(const Rule& rule, const RuleCase& pair);

/// The built-in packs in order: ctfs, forestgeo, scbi, treedata, lidar.
const std::vector<RulePack>& rule_packs();
const RulePack* find_rule_pack(const std::string& name);

/// "flag=too_fast;growth_above_cm_per_year=3;species=Populus,Salix": how a project keeps a person's own rules. Keys: flag, meaning,
/// growth_above_cm_per_year, growth_at_least_cm_per_year, change_below_cm, ratio_below, ratio_above,
/// shrinkage_percent_per_year, sd_slope, sd_intercept_cm, sd_times, error_sigmas, least_dbh_cm, species, not_species.
Result<Rule> rule_from_text(const std::string& text);
std::string to_text(const Rule& rule);

/// The pack that a project has chosen, built-in or its own; nothing when none. Kept in its settings.
std::optional<RulePack> chosen_rules(const ProjectState& state);
/// The settings that keep a choice: key and value. `pack` none: no rules.
std::vector<std::pair<std::string, std::string>> settings_of(const std::optional<RulePack>& pack);

struct RuleCount {
  std::string flag, meaning;
  int broken = 0, judged = 0;   ///< pairs of sightings
};
/// How many pairs every rule would flag: before anything is applied.
std::vector<RuleCount> count_broken(const RulePack& pack, const Tables& tables);

/// Adds the flags of the chosen pack to matches and trees. Rejected pairs are not judged.
void flag_implausible(const ProjectState& state, Tables& tables);

}  // namespace stemwise
