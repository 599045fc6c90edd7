#include "io/report/number_text.hpp"
#include "io/report/sections.hpp"

namespace stemwise {
namespace {

std::string name_of(const ReportModel& model, InventoryId id) {
  for (const ReportSurvey& survey : model.surveys)
    if (survey.id == id) return survey.name;
  return "";
}

const char* policy_text(FusionPolicy policy) {
  switch (policy) {
    case FusionPolicy::min_dbh: return "the smallest of the measured diameters";
    case FusionPolicy::newest: return "the newest measured diameter";
    case FusionPolicy::best: return "the measured diameter with the least error to be expected (the survey's DBH error, how well and how often the stem was seen)";
    case FusionPolicy::mean: return "the mean of the measured diameters, weighted by each survey's DBH error";
  }
  return "";
}

ReportTable conflict_table(const ReportModel& model) {
  ReportTable table{"Conflicts", "", {{"Tree", false}, {"Attribute", false}, {"What the surveys say", false}, {"Merged value", false}, {"From", false}}, {}};
  table.printed_rows = 45;
  for (const FusionConflict& c : model.conflicts) {
    std::string values;
    for (const auto& [survey, value] : c.values) values += (values.empty() ? "" : "; ") + name_of(model, survey) + " " + value;
    const std::string from = c.source ? name_of(model, c.source) : "";
    table.rows.push_back({tree_label(c.tree), c.attribute, values, c.kept, c.by_hand ? from + (from.empty() ? "" : ", ") + "by hand" : from});
  }
  table.note = "Trees whose surveys differ by more than errors of measurement explain: species names that differ; a diameter (cm) that shrank, or grew beyond belief; a stem more than a "
               "metre, and four position errors, off the merged place; alive after dead. Nothing is left out of the merged inventory for it.";
  return table;
}

ReportTable ground_table(const ReportModel& model) {
  ReportTable table{"How often the ground was surveyed", "", {{"Surveys"}, {"Ground ha"}}, {}};
  for (std::size_t k = model.ground.ha_by_surveys.size(); k-- > 0;) table.rows.push_back({std::to_string(k + 1), fixed(model.ground.ha_by_surveys[k], 2)});
  table.note = "Counted in squares of " + fixed(model.ground.square_m, 0) + " m by their centres.";
  return table;
}

ReportTable under_observed_table(const ReportModel& model) {
  ReportTable table{"Under-observed ground", "", {{"x m"}, {"y m"}, {"Surveys"}, {"Trees"}, {"Seen %"}}, {}};
  table.printed_rows = 30;
  for (const ObservedSquare& s : model.ground.under_observed)
    table.rows.push_back({fixed(s.centre_m.x(), 0), fixed(s.centre_m.y(), 0), std::to_string(s.surveys), std::to_string(s.trees), s.trees > 0 ? fixed(100.0 * s.seen_share, 0) : ""});
  table.note = "Squares of " + fixed(model.ground.square_m, 0) + " m, by their centres in the frame of " + model.reference +
               ", that fewer than all surveys looked at, or whose trees had fewer than 60 % of the sightings that those surveys could have had. The worst first.";
  return table;
}

}  // namespace

ReportSection merge_section(const ReportModel& model) {
  ReportSection section{"The merged inventory", {}};
  std::string text = "The merged DBH of a tree is " + std::string(policy_text(model.fusion)) +
                     "; its place the mean of its sightings, weighted by each survey's position error; its species the newest that is given.";
  if (model.chosen_by_hand > 0) text += " For " + std::to_string(model.chosen_by_hand) + " trees a person chose the survey that a value comes from.";
  section.blocks.emplace_back(ReportParagraph{text});
  if (!model.conflicts.empty()) section.blocks.emplace_back(conflict_table(model));
  if (!model.ground.ha_by_surveys.empty()) section.blocks.emplace_back(ground_table(model));
  if (!model.ground.under_observed.empty()) section.blocks.emplace_back(under_observed_table(model));
  return section;
}

}  // namespace stemwise
