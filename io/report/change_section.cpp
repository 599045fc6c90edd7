#include <cmath>

#include "io/report/number_text.hpp"
#include "io/report/sections.hpp"

namespace stemwise {
namespace {

const char* const square_metres = "m\u00b2";

std::string name_of(const ReportModel& model, InventoryId id) {
  for (const ReportSurvey& survey : model.surveys)
    if (survey.id == id) return survey.name;
  return "";
}

template <class Step>
std::string span_of(const ReportModel& model, const Step& step) {
  return name_of(model, step.from) + " to " + name_of(model, step.to);
}

std::string interval(const Estimate& estimate, double factor, int decimals) {
  return fixed(estimate.ci95[0] * factor, decimals) + " to " + fixed(estimate.ci95[1] * factor, decimals);
}

/// "" instead of a basal area that the component cannot have.
std::string area_or_nothing(bool has, double sq_m) { return has ? fixed(sq_m, 3) : ""; }

ReportTable component_table(const ReportModel& model, const StandChange& change) {
  ReportTable table{"Components of change, " + span_of(model, change), "", {{"Component", false}, {"Stems"}, {std::string("Earlier ") + square_metres},
                    {std::string("Later ") + square_metres}, {std::string("Change ") + square_metres}}, {}};
  if (change.area_ha) table.columns.push_back({std::string("Change ") + square_metres + "/ha"});
  const auto add = [&](const std::string& label, const ComponentSum& sum, bool earlier, bool later, const std::optional<double>& on_ground_sq_m) {
    std::vector<std::string> row{label, std::to_string(sum.stems), area_or_nothing(earlier, sum.earlier_sq_m), area_or_nothing(later, sum.later_sq_m), fixed(sum.growth_sq_m(), 3)};
    if (change.area_ha) row.push_back(on_ground_sq_m ? fixed(*on_ground_sq_m / *change.area_ha, 3) : "");
    table.rows.push_back(std::move(row));
  };
  ComponentSum all;
  double on_ground_sq_m = 0.0;  // what stands where both surveys looked: only that is divided by their common hectares
  for (std::size_t i = 0; i < component_count; ++i) {
    const auto component = static_cast<Component>(i);
    const ComponentSum& sum = of(change.all, component);
    all.stems += sum.stems, all.earlier_sq_m += sum.earlier_sq_m, all.later_sq_m += sum.later_sq_m;
    const bool beyond = component == Component::not_surveyed_before || component == Component::not_surveyed_after;
    if (!beyond) on_ground_sq_m += sum.growth_sq_m();
    if (sum.stems > 0) add(component_label(component), sum, component == Component::survivor || is_loss(component), !is_loss(component), beyond ? std::nullopt : std::optional(sum.growth_sq_m()));
  }
  add("Stock", all, true, true, on_ground_sq_m);
  table.note = "Every living stem with a DBH is in exactly one component: the later stock is the earlier one, plus what survivors grew, plus all that came, less all that went. ";
  table.note += change.area_ha ? "Hectares: " + fixed(*change.area_ha, 3) + " (" + change.area_source + "); what one survey did not look at lies elsewhere and is not divided by them." : "No area is known: nothing is said per hectare.";
  if (change.beyond_drawn > 0) table.note += " " + std::to_string(change.beyond_drawn) + " trees stand outside the coverage that was drawn for a survey that saw them, and are in no component.";
  if (change.without_dbh > 0) table.note += " " + std::to_string(change.without_dbh) + " living stems lack a DBH and are in no component.";
  return table;
}

ReportTable increment_table(const ReportModel& model) {
  ReportTable table{"Periodic annual increment of basal area", "", {{"From", false}, {"To", false}, {"Years"}, {"Survivor growth"}, {"Ingrowth"}, {"Gross growth"},
                    {"Mortality and missing"}, {"Removal"}, {"Net growth"}, {"Unit", false}}, {}};
  for (const StandChange& change : model.changes) {
    const std::optional<PeriodicIncrement> increment = periodic_increment(change);
    if (!increment) continue;
    const std::string unit = std::string(square_metres) + (increment->per_ha ? "/ha/year" : "/year");
    table.rows.push_back({name_of(model, change.from), name_of(model, change.to), fixed(change.years, 2), fixed(increment->survivor_growth_sq_m, 3), fixed(increment->ingrowth_sq_m, 3),
                          fixed(increment->gross_growth_with_ingrowth_sq_m(), 3), fixed(increment->mortality_sq_m, 3), fixed(increment->removal_sq_m, 3),
                          fixed(increment->net_growth_sq_m(), 3), unit});
  }
  table.note = "Gross growth: survivors and ingrowth. Net growth: gross growth less mortality, missing and removal, by their earlier DBH. Trees that were missed, or not surveyed, at one end "
               "are in none of them: their arrival is no growth.";
  return table;
}

struct Group {
  std::string name;
  const ComponentTable* table = nullptr;
};

ReportTable group_table(std::string title, const char* what, const std::vector<Group>& groups, std::string note) {
  ReportTable table{std::move(title), std::move(note), {{what, false}, {"Survivors"}, {std::string("Growth ") + square_metres}, {"Ingrowth"}, {std::string("Ingrowth ") + square_metres},
                    {"Dead or missing"}, {std::string("Dead or missing ") + square_metres}, {"Removed"}, {"Other"}, {std::string("Net ") + square_metres}}, {}};
  for (const Group& group : groups) {
    const ComponentTable& c = *group.table;
    const ComponentSum &stay = of(c, Component::survivor), &in = of(c, Component::ingrowth), &dead = of(c, Component::dead), &missing = of(c, Component::missing),
                       &removed = of(c, Component::removed);
    int all = 0;
    double net_sq_m = 0.0;
    for (const ComponentSum& sum : c) all += sum.stems, net_sq_m += sum.growth_sq_m();
    const int other = all - stay.stems - in.stems - dead.stems - missing.stems - removed.stems;
    table.rows.push_back({group.name, std::to_string(stay.stems), fixed(stay.growth_sq_m(), 3), std::to_string(in.stems), fixed(in.later_sq_m, 3), std::to_string(dead.stems + missing.stems),
                          fixed(dead.earlier_sq_m + missing.earlier_sq_m, 3), std::to_string(removed.stems), std::to_string(other), fixed(net_sq_m, 3)});
  }
  return table;
}

std::string class_name(double low_cm, double high_cm) {
  const int decimals = std::abs(high_cm - low_cm - std::round(high_cm - low_cm)) < 1e-9 ? 0 : 1;
  return "[" + fixed(low_cm, decimals) + ", " + fixed(high_cm, decimals) + ")";
}

std::string species_name(const std::string& species) { return species.empty() ? "not given" : species; }

void add_groups(const ReportModel& model, const StandChange& change, ReportSection& section) {
  std::vector<Group> species, classes;
  bool any_species = false;
  for (const SpeciesChange& s : change.by_species) species.push_back({species_name(s.species), &s.table}), any_species = any_species || !s.species.empty();
  for (const ClassChange& c : change.by_class) classes.push_back({class_name(c.low_cm, c.high_cm), &c.table});
  const std::string other = "Other: missed at one end, not surveyed there, or too near the edge to say; the net change contains them.";
  if (any_species) section.blocks.emplace_back(group_table("By species, " + span_of(model, change), "Species", species, other));
  if (!classes.empty())
    section.blocks.emplace_back(group_table("By DBH class, " + span_of(model, change), "DBH class cm", classes,
                                            "Survivors and losses by their earlier, what came by its later DBH; the lower limit belongs to the class. " + other));
}

ReportTable growth_group_table(const ReportModel& model, const std::vector<GrowthGroup>& groups, const char* title, const char* what) {
  ReportTable table{title, "", {{"From", false}, {"To", false}, {what, false}, {"Stems"}, {"Mean change cm"}, {"95 % interval cm"}, {"Mean mm/year"}, {"95 % interval mm/year"}}, {}};
  table.printed_rows = 60;
  for (const GrowthGroup& g : groups)
    table.rows.push_back({name_of(model, g.from), name_of(model, g.to), g.high_cm > 0.0 ? class_name(g.low_cm, g.high_cm) : species_name(g.species), std::to_string(g.n), fixed(g.mean_m.value * 100.0, 2),
                          g.n > 1 ? interval(g.mean_m, 100.0, 2) : "", g.has_years ? fixed(g.mean_m_per_year.value * 1000.0, 1) : "", g.has_years && g.n > 1 ? interval(g.mean_m_per_year, 1000.0, 1) : ""});
  table.note = "Matched living stems with two diameters; bootstrap intervals of the mean. A group of a few stems has an interval that is too narrow to be trusted.";
  return table;
}

}  // namespace

ReportSection change_section(const ReportModel& model) {
  ReportSection section{"Components of change", {}};
  if (model.changes.empty()) {
    section.blocks.emplace_back(ReportParagraph{"One survey has no change to report.", true});
    return section;
  }
  section.blocks.emplace_back(increment_table(model));
  for (const StandChange& change : model.changes) {
    section.blocks.emplace_back(component_table(model, change));
    add_groups(model, change, section);
  }
  return section;
}

ReportSection interval_section(const ReportModel& model) {
  ReportSection section{"Growth of the stand, with its uncertainty", {}};
  ReportTable table{"Growth of the stand", "", {{"From", false}, {"To", false}, {"Years"}, {"Stems"}, {"Mean cm"}, {"95 % interval"}, {"Mean mm/year"}, {"95 % interval"}, {"Median cm"},
                    {"95 % interval"}, {"Robust cm"}, {"95 % interval"}, {"One tree shows cm"}}, {}};
  for (const StandGrowth& g : model.stand_growth) {
    if (g.n == 0) continue;
    table.rows.push_back({name_of(model, g.from), name_of(model, g.to), fixed(g.years, 2), std::to_string(g.n), fixed(g.mean_m.value * 100.0, 2), interval(g.mean_m, 100.0, 2),
                          g.years ? fixed(g.mean_m_per_year.value * 1000.0, 1) : "", g.years ? interval(g.mean_m_per_year, 1000.0, 1) : "", fixed(g.median_m.value * 100.0, 2),
                          interval(g.median_m, 100.0, 2), fixed(g.robust_m.value * 100.0, 2), interval(g.robust_m, 100.0, 2), fixed(g.detection_limit_m * 100.0, 1)});
  }
  table.note = "DBH change of matched living stems. Mean: bias-corrected bootstrap; robust: Huber's estimate, in which gross errors count little. Errors of measurement leave the mean "
               "where it is, and draw the median of a skewed stand towards it: the median's interval allows for that. One tree shows: a change of one tree below this may be error of measurement alone.";
  section.blocks.emplace_back(std::move(table));
  if (!model.growth_groups.by_species.empty())
    section.blocks.emplace_back(growth_group_table(model, model.growth_groups.by_species, "Growth by species", "Species"));
  if (!model.growth_groups.by_class.empty())
    section.blocks.emplace_back(growth_group_table(model, model.growth_groups.by_class, "Growth by DBH class", "Earlier DBH cm"));
  return section;
}

}  // namespace stemwise
