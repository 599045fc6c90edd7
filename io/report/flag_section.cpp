#include "io/report/number_text.hpp"
#include "io/report/sections.hpp"

namespace stemwise {
namespace {

ReportTable rule_table(const ReportModel& model) {
  ReportTable table{"Rules and what they flag", "", {{"Pack", false}, {"Rule", false}, {"Meaning", false}, {"Flagged"}, {"Judged"}, {"Chosen", false}}, {}};
  for (const ReportRule& rule : model.rules)
    table.rows.push_back({rule.pack, rule.count.flag, rule.count.meaning, std::to_string(rule.count.broken), std::to_string(rule.count.judged), rule.is_chosen ? "yes" : ""});
  table.note = "Counted over pairs of consecutive sightings of one tree. A rule by the year judges only pairs with dates. Rules flag; they change and delete nothing: "
               "no figure of this report leaves a flagged tree out.";
  return table;
}

ReportTable tree_table(const ReportModel& model) {
  ReportTable table{"Flagged trees", "", {{"Tree", false}, {"From", false}, {"To", false}, {"DBH before cm"}, {"DBH after cm"}, {"Change cm"}, {"cm/year"}, {"Flags", false}, {"Species", false}}, {}};
  table.printed_rows = 45;
  for (const ReportFlagged& f : model.flagged)
    table.rows.push_back({tree_label(f.tree), model.surveys[f.from].name, model.surveys[f.to].name, fixed(f.earlier_dbh_m * 100.0, 1), fixed(f.later_dbh_m * 100.0, 1),
                          fixed((f.later_dbh_m - f.earlier_dbh_m) * 100.0, 1), fixed(f.growth_m_per_year, 2, 100.0), f.flags, f.species});
  table.note = "Pairs of sightings that break a rule of the chosen pack, the largest change first. A person decides what is wrong: a diameter, a match, or nothing.";
  return table;
}

}  // namespace

ReportSection flag_section(const ReportModel& model) {
  ReportSection section{"Plausibility of growth", {}};
  std::string text = "Rule pack: " + (model.rule_pack.empty() ? std::string("none chosen, so no pack's rules are judged") : model.rule_pack) + ".";
  text += " Whatever the pack, the exports flag matches that shrank beyond the error of measurement (shrinkage), grew more than trees do (implausible_growth), live after they were recorded as dead "
          "(alive_after_dead) or lack a diameter (no_dbh).";
  section.blocks.emplace_back(ReportParagraph{text});
  if (!model.rules.empty()) section.blocks.emplace_back(rule_table(model));
  if (!model.rule_pack.empty()) section.blocks.emplace_back(tree_table(model));
  return section;
}

}  // namespace stemwise
