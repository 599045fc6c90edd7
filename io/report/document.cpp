#include "io/report/document.hpp"

#include <algorithm>
#include <cmath>

#include "io/report/charts.hpp"
#include "io/report/number_text.hpp"
#include "io/report/sections.hpp"

namespace stemwise {
namespace {

std::string observed_text(const ReportSurvey& survey) {
  if (survey.status == AlignmentStatus::reference) return "";
  const char* const words[] = {"x", "y", "yaw", "z", "roll", "pitch"};
  std::string text;
  for (std::size_t i = 0; i < 6; ++i) {
    if (survey.observed.seen[i]) text += (text.empty() ? "" : " ") + std::string(words[i]);
  }
  return text;
}

std::string span_text(const ReportModel& model, const ReportGrowth& growth) {
  return model.surveys[growth.from].name + " to " + model.surveys[growth.to].name;
}

std::string band_text(const std::array<double, 2>& band_m) { return fixed(band_m[0] * 100.0, 1) + " to " + fixed(band_m[1] * 100.0, 1); }

ReportFigures key_figures(const ReportModel& model) {
  ReportFigures figures;
  figures.push_back({grouped(static_cast<int>(model.trees.size())), "trees", "in " + std::to_string(model.placed) + " surveys"});
  if (model.growth.empty()) return figures;
  const ReportGrowth& last = model.growth.back();
  figures.push_back({grouped(last.survivors), "matched stems", span_text(model, last)});
  if (last.row.n > 0) {
    const bool annual = last.row.years && std::abs(*last.row.years) > 0.05;
    const double factor = annual ? 10.0 * 100.0 / *last.row.years : 10.0 * 100.0;
    figures.push_back({fixed(last.row.median_change_m * factor, 1) + " mm", annual ? "median DBH growth a year" : "median DBH growth",
                       "20-80 % band " + fixed(last.row.p20_p80_m[0] * factor, 1) + " to " + fixed(last.row.p20_p80_m[1] * factor, 1) + " mm"});
  }
  figures.push_back({grouped(last.new_stems), "new stems", "in " + model.surveys[last.to].name});
  figures.push_back({grouped(last.missing_stems), "missing stems", "seen in " + model.surveys[last.from].name + ", not in " + model.surveys[last.to].name});
  return figures;
}

ReportTable survey_table(const ReportModel& model) {
  ReportTable table{"Surveys and alignment", "", {{"Survey", false}, {"Date", false}, {"Stems"}, {"Status", false}, {"Matched"}, {"Overlap"},
                    {"Residual cm"}, {"Position noise cm"}, {"Margin"}, {"Observed", false}, {"DBH error cm"}}, {}};
  for (const ReportSurvey& s : model.surveys) {
    const bool aligned = s.placed && s.status != AlignmentStatus::reference;
    table.rows.push_back({s.name, date_text(s.date), std::to_string(s.stems), to_string(s.status), aligned ? std::to_string(s.matched) : "",
                          aligned ? fixed(s.overlap, 2) : "", aligned ? fixed(s.residual_rms_m * 100.0, 1) : "",
                          aligned ? fixed(s.position_noise_m * 100.0, 1) : "", aligned ? fixed(s.margin, 0) : "", observed_text(s),
                          fixed(s.dbh_error_m, 1, 100.0)});
  }
  table.note = "Residual: root mean square of the planar distances between matched stems. Margin: log-likelihood by which the pose beats the next "
               "best one and the best pose of the mirrored survey; above 15 counts as certain. Observed: the degrees of freedom that the stems determine.";
  return table;
}

ReportSection survey_section(const ReportModel& model) {
  ReportSection section{"Surveys and alignment quality", {}};
  section.blocks.emplace_back(survey_table(model));
  for (const ReportSurvey& s : model.surveys) {
    if (s.placed || s.reason.empty()) continue;
    section.blocks.emplace_back(ReportParagraph{s.name + " is not part of this report: " + s.reason, true});
  }
  for (const ReportSurvey& s : model.surveys)
    for (const std::string& note : s.trajectory_notes) section.blocks.emplace_back(ReportParagraph{note});
  std::string text = "All positions are in the frame of " + model.reference + ". ";
  text += model.georeference.empty() ? "The project is not georeferenced." : "Placed on the earth by " + model.georeference + ".";
  if (model.decisions_by_hand > 0) text += " " + std::to_string(model.decisions_by_hand) + " matches were decided by hand.";
  section.blocks.emplace_back(ReportParagraph{text});
  return section;
}

ReportTable stand_table(const ReportModel& model) {
  ReportTable table{"Stand figures", "", {{"Survey", false}, {"Living stems"}, {"With DBH"}, {"Mean DBH cm"}, {"Quadratic mean cm"}, {"Basal area m\u00b2"},
                    {"Area ha"}, {"Stems per ha"}, {"Basal area m\u00b2/ha"}, {"Area from", false}}, {}};
  bool any_area = false;
  for (std::size_t i = 0; i < model.placed; ++i) {
    const ReportSurvey& s = model.surveys[i];
    const int living = s.stems_with_dbh + model.without_dbh[i];
    std::vector<std::string> row{s.name, std::to_string(living), std::to_string(s.stems_with_dbh), fixed(s.mean_dbh_m, 1, 100.0),
                                 fixed(s.quadratic_mean_dbh_m, 1, 100.0), fixed(s.basal_area_sq_m, 2)};
    if (s.area) {
      any_area = true;
      row.insert(row.end(), {fixed(s.area->ha, 3), fixed(living / s.area->ha, 0), fixed(s.basal_area_sq_m / s.area->ha, 2), s.area->source});
    } else {
      row.insert(row.end(), {"", "", "", "no area known"});
    }
    table.rows.push_back(std::move(row));
  }
  table.note = "Basal area and mean DBH are over the living stems with a measured DBH; stems marked dead are in no figure of this table. ";
  for (std::size_t i = 0; i < model.placed; ++i)
    if (const ReportSurvey& s = model.surveys[i]; s.beyond_area > 0)
      table.note += "Of " + s.name + " " + std::to_string(s.beyond_area) + " living stems lie outside the coverage that was drawn and are in no figure of this table. ";
  table.note += any_area ? "The hectares behind the per-hectare figures, and where they come from, stand in the table."
                         : "Without an area there are no per-hectare figures.";
  return table;
}

ReportTable fate_table(const ReportModel& model) {
  ReportTable table{"Trees by fate", "", {{"Fate", false}, {"Trees"}, {"Share %"}}, {}};
  for (std::size_t i = 0; i < fate_count; ++i) {
    const int n = model.trees_by_fate[i];
    if (n == 0) continue;
    table.rows.push_back({fate_label(static_cast<Fate>(i)), std::to_string(n), fixed(100.0 * n / std::max<std::size_t>(1, model.trees.size()), 1)});
  }
  table.note = "Every tree of the project, by the last two surveys: also those that were lost, or missed, before. Missing means missing inside the later survey's coverage: whether a tree died or was removed is for a "
               "person to decide. A tree outside the coverage was not surveyed, and is not dead.";
  return table;
}

ReportTable growth_table(const ReportModel& model) {
  ReportTable table{"DBH change", "", {{"From", false}, {"To", false}, {"Years"}, {"Matched"}, {"Living, two DBHs"}, {"Median change cm"}, {"95 % interval cm"},
                    {"20-80 % band cm"}, {"Median mm/year"}, {"DBH error cm"}, {"Grew"}, {"Shrank"}, {"Within error"}}, {}};
  for (const ReportGrowth& g : model.growth) {
    const bool any = g.row.n > 0;
    const bool annual = any && g.row.years && std::abs(*g.row.years) > 0.05;
    table.rows.push_back({model.surveys[g.from].name, model.surveys[g.to].name, fixed(g.row.years, 2), std::to_string(g.survivors), std::to_string(g.row.n),
                          any ? fixed(g.row.median_change_m * 100.0, 2) : "", any ? band_text(g.row.ci95_m) : "", any ? band_text(g.row.p20_p80_m) : "",
                          annual ? fixed(g.row.median_change_m * 1000.0 / *g.row.years, 1) : "", any ? fixed(g.row.dbh_error_m * 100.0, 1) : "",
                          std::to_string(g.grew), std::to_string(g.shrank), std::to_string(g.within_error)});
  }
  table.note = "Stems that were dead or removed in either survey are matched, and no change is told of them. The interval is that of the true median: errors of measurement draw the median of a skewed stand towards its mean, which is allowed for. The 20-80 % band holds the middle three fifths of the changes. The DBH error is one "
               "measurement's, estimated from the matched stems; a stem grew or shrank only where its change exceeds what that error explains.";
  return table;
}

ReportSection growth_section(const ReportModel& model) {
  ReportSection section{"DBH change of matched stems", {}};
  if (model.growth.empty()) {
    section.blocks.emplace_back(ReportParagraph{"No two surveys share a stem: there is no growth to report.", true});
    return section;
  }
  section.blocks.emplace_back(growth_table(model));
  for (const ReportGrowth& g : model.growth) {
    if (g.changes_m.empty()) continue;
    section.blocks.emplace_back(ReportChart{draw_change_histogram(model, g),
                                            "DBH change, " + span_text(model, g) + ": " + std::to_string(g.changes_m.size()) +
                                                " stems; the 20-80 % band is shaded. The outermost bars hold everything beyond them."});
  }
  return section;
}

ReportTable dbh_class_table(const ReportModel& model) {
  ReportTable table{"Living stems per DBH class", "", {{"DBH class cm", false}}, {}};
  for (std::size_t s = 0; s < model.placed; ++s) table.columns.push_back({model.surveys[s].name + " stems"});
  for (std::size_t s = 0; s < model.placed; ++s) {
    if (model.surveys[s].area) table.columns.push_back({model.surveys[s].name + " per ha"});
  }
  for (std::size_t s = 0; s < model.placed; ++s) table.columns.push_back({model.surveys[s].name + " m\u00b2"});
  const auto row_of = [&](std::string name, const std::vector<int>& stems, const std::vector<double>* basal) {
    std::vector<std::string> row{std::move(name)};
    for (std::size_t s = 0; s < model.placed; ++s) row.push_back(std::to_string(stems[s]));
    for (std::size_t s = 0; s < model.placed; ++s) {
      if (model.surveys[s].area) row.push_back(fixed(stems[s] / model.surveys[s].area->ha, 1));
    }
    for (std::size_t s = 0; s < model.placed; ++s) row.push_back(basal == nullptr ? "" : fixed((*basal)[s], 2));
    return row;
  };
  const int decimals = std::abs(model.options.dbh_class_width_cm - std::round(model.options.dbh_class_width_cm)) < 1e-9 ? 0 : 1;
  std::vector<int> total = model.without_dbh;
  for (const ReportDbhClass& c : model.dbh_classes) {
    table.rows.push_back(row_of("[" + fixed(c.low_cm, decimals) + ", " + fixed(c.high_cm, decimals) + ")", c.stems, &c.basal_area_sq_m));
    for (std::size_t s = 0; s < model.placed; ++s) total[s] += c.stems[s];
  }
  table.rows.push_back(row_of("without DBH", model.without_dbh, nullptr));
  table.rows.push_back(row_of("all", total, nullptr));
  table.note = "Class width " + fixed(model.options.dbh_class_width_cm, decimals) +
               " cm. Intervals [low, high): the lower limit belongs to the class, the upper to the next. Living stems; those outside the other surveys' "
               "coverage are counted too.";
  return table;
}

ReportSection structure_section(const ReportModel& model) {
  ReportSection section{"Stand structure", {}};
  section.blocks.emplace_back(stand_table(model));
  if (!model.dbh_classes.empty()) {
    section.blocks.emplace_back(ReportChart{draw_dbh_classes(model), "Living stems per DBH class and survey."});
    section.blocks.emplace_back(dbh_class_table(model));
  }
  return section;
}

ReportTable stem_table(const ReportModel& model, const char* title, const std::vector<ReportStem>& stems, const char* note) {
  ReportTable table{title, note, {{"Tree", false}, {"Survey", false}, {"Fate", false}, {"DBH cm"}, {"x m"}, {"y m"}, {"Species", false}}, {}};
  table.printed_rows = 45;
  for (const ReportStem& stem : stems) {
    table.rows.push_back({tree_label(stem.tree), model.surveys[stem.survey].name, fate_label(stem.fate), fixed(stem.dbh_m, 1, 100.0),
                          fixed(stem.position_m.x(), 2), fixed(stem.position_m.y(), 2), stem.species});
  }
  return table;
}

ReportSection fate_section(const ReportModel& model) {
  ReportSection section{"What became of the trees", {}};
  section.blocks.emplace_back(fate_table(model));
  return section;
}

ReportSection list_section(const ReportModel& model) {
  ReportSection section{"New and missing stems", {}};
  section.blocks.emplace_back(stem_table(model, "New stems", model.new_stems,
                                         "Seen first in the survey named, inside the coverage of the one before. Ingrowth: small enough to have grown in; "
                                         "missed earlier: too big for that. Largest first."));
  section.blocks.emplace_back(stem_table(model, "Missing stems", model.missing_stems,
                                         "Seen last in the survey named, inside the coverage of the next one. Largest first."));
  return section;
}

ReportCover cover_of(const ReportModel& model, const std::string& software) {
  ReportCover cover;
  cover.figures = key_figures(model);
  if (!model.trees.empty())
    cover.map = ReportChart{draw_fate_map(model), "Every merged tree by what became of it between the last two surveys; the circles follow DBH, enlarged to be seen."};
  for (std::size_t i = 0; i < model.placed; ++i) {
    const ReportSurvey& s = model.surveys[i];
    std::string text = std::to_string(s.stems) + " stems" + (s.date ? ", " + to_string(*s.date) : ", no date");
    if (s.area) text += ", " + fixed(s.area->ha, 2) + " ha (" + s.area->source + ")";
    cover.facts.emplace_back("Survey " + s.name, text);
  }
  cover.facts.emplace_back("Coordinates", model.georeference.empty() ? "local, in the frame of " + model.reference : "placed on the earth by " + model.georeference);
  cover.facts.emplace_back("Made with", software);
  return cover;
}

}  // namespace

ReportDocument make_report_document(const ReportModel& model, const std::string& software) {
  ReportDocument document;
  document.title = model.title.empty() ? "Growth report" : "Growth report: " + model.title;
  for (std::size_t i = 0; i < model.placed; ++i) document.subtitle += (i == 0 ? "Surveys " : ", ") + model.surveys[i].name;
  document.footer = software;
  document.cover = cover_of(model, software);
  document.sections = {survey_section(model), fate_section(model),  growth_section(model), interval_section(model),          change_section(model),
                       structure_section(model), flag_section(model), list_section(model), merge_section(model), method_section(model, software), dictionary_section()};
  return document;
}

}  // namespace stemwise
