#include "io/report/field_check.hpp"

#include "io/crs.hpp"
#include "io/earth_frame.hpp"
#include "io/report/drawing.hpp"
#include "io/report/number_text.hpp"
#include "io/replace_file.hpp"

namespace stemwise {
namespace {

std::string way_text(const FieldBearing& b) {
  return fixed(b.distance_m, 2) + " m at " + fixed(b.azimuth_deg, 0) + "\u00b0 from " + tree_label(b.from) + (b.dbh_m ? " (" + fixed(*b.dbh_m * 100.0, 0) + " cm)" : "");
}

ReportTable print_sheet(const FieldCheck& check) {
  ReportTable table{"Trees to look at", "", {{"Tree", false}, {"What is doubtful", false}, {"DBH cm"}, {"First way", false}, {"Second way", false}, {"Third way", false}, {"Found, note", false}}, {}};
  for (const FieldCheckRow& row : check.rows) {
    std::vector<std::string> cells{tree_label(row.tree), row.why, fixed(row.dbh_m, 1, 100.0)};
    for (std::size_t i = 0; i < 3; ++i)
      cells.push_back(i < row.bearings.size() ? tree_label(row.bearings[i].from) + ": " + fixed(row.bearings[i].distance_m, 2) + " m, " + fixed(row.bearings[i].azimuth_deg, 0) + "\u00b0" : "");
    cells.emplace_back("...............");
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Coordinates on the earth, as columns behind the others.
void add_places(ReportTable& table, const FieldCheck& check, const EarthFrame& frame) {
  const int decimals = is_geographic_epsg(*frame.epsg()) ? 9 : 2;
  const std::string in = " in " + crs_name(*frame.epsg()) + " (EPSG:" + std::to_string(*frame.epsg()) + ")";
  for (const std::string& column : {"x" + in, "y" + in, std::string("lon \u00b0"), std::string("lat \u00b0")}) table.columns.push_back({column});
  for (std::size_t i = 0; i < check.rows.size(); ++i) {
    const auto at = frame.target_from_reference(check.rows[i].position_m);
    const auto earth = frame.geodetic_from_reference(check.rows[i].position_m);
    table.rows[i].insert(table.rows[i].end(), {at ? fixed(at->x(), decimals) : "", at ? fixed(at->y(), decimals) : "", earth ? fixed(earth->longitude_deg, 9) : "", earth ? fixed(earth->latitude_deg, 9) : ""});
  }
}

ReportTable number_sheet(const FieldCheck& check) {
  ReportTable table{"Trees to look at", "", {{"Tree", false}, {"What is doubtful", false}, {"DBH cm"}, {"x m"}, {"y m"}, {"Species", false}}, {}};
  for (const char* n : {"1", "2", "3"}) {
    table.columns.push_back({std::string("From ") + n, false});
    table.columns.push_back({std::string("Distance ") + n + " m"});
    table.columns.push_back({std::string("Azimuth ") + n + " \u00b0"});
  }
  for (const FieldCheckRow& row : check.rows) {
    std::vector<std::string> cells{tree_label(row.tree), row.why, fixed(row.dbh_m, 1, 100.0), fixed(row.position_m.x(), 2), fixed(row.position_m.y(), 2), row.species};
    for (std::size_t i = 0; i < 3; ++i) {
      if (i < row.bearings.size()) cells.insert(cells.end(), {tree_label(row.bearings[i].from), fixed(row.bearings[i].distance_m, 2), fixed(row.bearings[i].azimuth_deg, 1)});
      else cells.insert(cells.end(), 3, "");
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

ReportTable sheet(const FieldCheck& check, const Georeference& georeference, bool for_print) {
  ReportTable table = for_print ? print_sheet(check) : number_sheet(check);
  if (const auto frame = EarthFrame::of(georeference); !for_print && frame && !frame->is_local()) add_places(table, check, *frame);
  table.note = "A way: stand at the tree named, look along the azimuth (degrees clockwise from " + check.north +
               "), and go the distance, measured horizontally from stem centre to stem centre. The trees to start from are the three nearest that are sure.";
  return table;
}

}  // namespace

ReportDocument make_field_check_document(const FieldCheck& check, const ProjectState& state, const std::string& software, bool for_print) {
  ReportDocument document;
  document.title = "Field check" + (state.title.empty() ? std::string() : ": " + state.title);
  document.subtitle = std::to_string(check.rows.size()) + " trees, most doubtful first; azimuths from " + check.north;
  document.footer = software;
  ReportSection section{"Field check sheet", {}};
  if (check.rows.empty()) section.blocks.emplace_back(ReportParagraph{"No tree is in doubt: there is nothing to check."});
  else section.blocks.emplace_back(sheet(check, state.georeference, for_print));
  document.sections.push_back(std::move(section));
  return document;
}

Result<Done> write_field_check_gpx(const std::string& path, const FieldCheck& check, const Georeference& georeference, const std::string& software) {
  if (georeference.kind == GeoreferenceKind::none)
    return Result<Done>::failure(Issue{Severity::error, path, 0, "", "GPX needs a place on the earth and the project has no georeference", "give it an anchor, control points or a CRS (stemwise georeference), or write .pdf or .csv"});
  const auto frame = EarthFrame::of(georeference);
  if (!frame) return Result<Done>::failure(frame.issues);
  std::string gpx = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<gpx version=\"1.1\" creator=\"" + escape_markup(software) +
                    "\" xmlns=\"http://www.topografix.com/GPX/1/1\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
                    "xsi:schemaLocation=\"http://www.topografix.com/GPX/1/1 http://www.topografix.com/GPX/1/1/gpx.xsd\">\n"
                    "<metadata><name>Field check</name><desc>Trees in doubt; azimuths from " + escape_markup(check.north) + "; heights above " + escape_markup(frame->height_datum()) +
                    "</desc><time>" + timestamp_utc() + "</time></metadata>\n";
  for (const FieldCheckRow& row : check.rows) {
    const auto at = frame->geodetic_from_reference(row.position_m);
    if (!at) continue;
    std::string ways;
    for (const FieldBearing& b : row.bearings) ways += "; " + way_text(b);
    gpx += "<wpt lat=\"" + fixed(at->latitude_deg, 9) + "\" lon=\"" + fixed(at->longitude_deg, 9) + "\">" + (row.has_z ? "<ele>" + fixed(frame->given_height_m(*at), 2) + "</ele>" : "") + "<name>" +
           tree_label(row.tree) + "</name><desc>" + escape_markup(row.why + ways) + "</desc><sym>Flag, Red</sym></wpt>\n";
  }
  return write_text_file(path, gpx + "</gpx>\n");
}

}  // namespace stemwise
