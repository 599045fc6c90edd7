#include "io/report/number_text.hpp"
#include "core/survey/fusion_choices.hpp"
#include "io/report/sections.hpp"

namespace stemwise {
namespace {

ReportTable residual_table(const ReportModel& model) {
  ReportTable table{"Georeference: residuals", "", {{"Point", false}, {"Residual m"}, {"Leave-one-out m"}, {"Used", false}}, {}};
  table.printed_rows = 60;
  for (const ControlResidual& r : model.georeference_residuals)
    table.rows.push_back({r.name, fixed(r.residual_m, 2), fixed(r.leave_one_out_m, 2), r.used ? "yes" : "left out"});
  table.note = "Planar. Leave-one-out: against the place that the other points give it.";
  return table;
}

ReportTable settings_table(const ReportModel& model, const std::string& software) {
  ReportTable table{"Settings", "", {{"Setting", false}, {"Value", false}}, {}};
  const auto add = [&table](std::string key, std::string value) { table.rows.push_back({std::move(key), std::move(value)}); };
  add("software", software);
  add("reference", model.reference);
  add("fusion policy", to_string(model.fusion));
  add("DBH class width", fixed(model.options.dbh_class_width_cm, 1) + " cm");
  add("area", model.options.area_ha ? fixed(*model.options.area_ha, 4) + " ha, given" : "each survey's coverage");
  add("rules", model.rule_pack.empty() ? "none" : model.rule_pack);
  if (!model.settings.contains("seed")) add("seed", "0");
  for (const auto& [key, value] : model.settings)
    if (!key.starts_with("rules.") && !is_fusion_choice(key)) add(key, value);
  table.note = "Settings that are not listed have their defaults. The same input, settings and seed give the same figures.";
  return table;
}

const char* const paragraphs[] = {
    "Alignment: the surveys were laid on each other by their stems alone (TreeLoc++): poses are voted for by pairs of neighbouring stems, verified against what chance would give, and "
    "refined on the matched stems. A survey whose pose chance could explain is refused, not forced.",
    "Matching: each stem of one survey is matched to at most one of another, by distance and diameter; what a person linked or separated stays so. Trees seen in several surveys keep one id.",
    "Fates: a tree that a survey does not have counts as missing only inside that survey's coverage. Whether a missing tree died or was removed is said by a person or a field code, never by the program.",
    "Growth: the change of a tree is told apart from measurement error by each survey's DBH error, estimated from the spread of the matched stems' changes below their median. Approximate diameters "
    "enter no growth figure and no fusion.",
    "Stand figures: living stems with a measured diameter; basal area is the sum of pi/4 DBH squared, the quadratic mean diameter that of the mean basal area. Hectares are those of the table they stand in."};

}  // namespace

ReportSection method_section(const ReportModel& model, const std::string& software) {
  ReportSection section{"Method, settings and seed", {}};
  for (const char* text : paragraphs) section.blocks.emplace_back(ReportParagraph{text});
  if (!model.georeference.empty()) {
    std::string text = "Georeference: " + model.georeference + "; heights are above " + model.height_datum + ".";
    if (model.georeference_sd_m > 0.0) text += " Its position is known to " + fixed(model.georeference_sd_m, 2) + " m (one axis, standard deviation); every tree's uncertainty contains that.";
    section.blocks.emplace_back(ReportParagraph{text});
  }
  if (!model.georeference_residuals.empty()) section.blocks.emplace_back(residual_table(model));
  section.blocks.emplace_back(settings_table(model, software));
  return section;
}

ReportSection dictionary_section() {
  ReportTable table{"Words and units", "", {{"Word", false}, {"Unit", false}, {"Meaning", false}}, {}};
  table.rows = {{"DBH", "cm", "diameter of a stem over bark at 1.3 m above the ground"},
                {"basal area", "m\u00b2", "cross-section of the stems at 1.3 m; per hectare where an area is known"},
                {"quadratic mean diameter", "cm", "diameter of the stem of mean basal area"},
                {"residual", "cm", "planar distance between matched stems after alignment; root mean square"},
                {"position noise", "cm", "standard deviation, one axis, of the planar difference between matched stems"},
                {"overlap", "0 to 1", "matched stems among all stems inside both coverages"},
                {"DBH error", "cm", "standard deviation of one diameter measurement"},
                {"20-80 % band", "cm", "holds the middle three fifths of the changes"},
                {"survivor", "", "seen by both surveys"},
                {"ingrowth", "", "new, and small enough to have grown past the smallest DBH that the earlier survey took"},
                {"missed earlier", "", "new to the earlier survey, but too large to be ingrowth"},
                {"missing", "", "gone inside the later survey's coverage: dead or removed, a person decides which"},
                {"dead, removed", "", "a person or a field code says so"},
                {"outside coverage", "", "not surveyed; never counted as dead"},
                {"unresolved", "", "too near the edge of the coverage to say"},
                {"tree", "", "T-00001 and so on: the same id in every report, export and later run"},
                {"x, y, z", "m", "in the reference's frame where the report says so, else in the coordinate system named"}};
  table.note = "A year has 365.25 days. Intervals are of 95 %.";
  return {"Data dictionary", {table}};
}

}  // namespace stemwise
