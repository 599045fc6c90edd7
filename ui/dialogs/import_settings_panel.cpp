#include "ui/dialogs/import_settings_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

struct Scheme {
  const char* label;
  std::array<const char*, 2> kinds;
  std::array<const char*, 2> labels;
};
constexpr std::array<Scheme, 3> schemes{{{"x and y", {"x", "y"}, {"x (east)", "y (north)"}},
                                         {"longitude and latitude", {"lon", "lat"}, {"Longitude", "Latitude"}},
                                         {"azimuth and distance", {"azimuth", "distance"}, {"Azimuth", "Distance"}}}};

const std::vector<std::string>& units_of(const std::string& kind) {
  static const std::vector<std::string> none, diameters{"cm", "mm", "m", "in"}, lengths{"m", "dm", "cm", "ft"}, angles{"deg", "gon", "rad"};
  if (kind == "dbh" || kind == "circumference") return diameters;
  if (kind == "azimuth") return angles;
  if (kind == "x" || kind == "z" || kind == "height" || kind == "distance") return lengths;
  return none;
}

std::string unit_label(const std::string& unit) {
  if (unit == "in") return "inch";
  if (unit == "ft") return "feet";
  if (unit == "deg") return "degrees";
  if (unit == "rad") return "radians";
  return unit;
}

/// A name at the left of a line; the control follows at the right of it.
float label(Widgets& w, const char* text) {
  const float width = w.px(96);
  const Rect row = w.next_rect(width, w.px(28));
  w.text_in(row, text, TextRole::body, Tone::secondary);
  ImGui::Dummy({width, row.height});
  ImGui::SameLine(0, 0);
  return w.available_width();
}

int place_in(const std::vector<std::string>& items, const std::string& item) {
  const auto at = std::find(items.begin(), items.end(), item);
  return at == items.end() ? -1 : static_cast<int>(at - items.begin());
}

}  // namespace

void ImportSettingsPanel::fill_fields(const ImportFile& file) {
  if (path_ != file.path) scheme_.reset();
  path_ = file.path;
  read_ = file.settings;
  date_read_ = file.date;
  epsg_read_ = file.epsg;
  name_ = file.settings.name.empty() ? file.name : file.settings.name;
  date_ = !file.settings.no_date.empty() ? file.settings.no_date : file.settings.date ? to_string(*file.settings.date) : file.date ? to_string(*file.date) : "";
  epsg_ = file.settings.epsg ? std::to_string(*file.settings.epsg) : file.epsg ? std::to_string(*file.epsg) : "";
}

void ImportSettingsPanel::draw(Widgets& w, Frame& frame, const ImportFile& file, std::size_t index) {
  const bool other = path_ != file.path || !(read_ == file.settings) || date_read_ != file.date || epsg_read_ != file.epsg;
  if (other) fill_fields(file);  // else a person may be typing
  wanted_ = file.settings;
  ImGui::PushID(file.path.c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {w.px(8), w.px(4)});
  draw_general(w, file);
  if (!file.header.empty()) draw_columns(w, file);
  if (!file.codes.empty()) draw_codes(w, file);
  ImGui::PopStyleVar();
  ImGui::PopID();
  if (!(wanted_ == file.settings)) frame.requests.emit(request::ImportEdit{index, wanted_});
}

void ImportSettingsPanel::draw_general(Widgets& w, const ImportFile& file) {
  const float width = label(w, "Name") - w.px(22);
  w.input("import/name", name_, {.hint = file.name, .width = width});
  if (ImGui::IsItemDeactivatedAfterEdit()) wanted_.name = name_;
  draw_date(w, file);
  if (!file.header.empty()) draw_system(w, file);
  draw_part(w, file);
}

void ImportSettingsPanel::draw_date(Widgets& w, const ImportFile& file) {
  const float width = label(w, "Date") - w.px(22);
  w.input("import/date", date_, {.hint = "not known; write 2023-05-04", .width = width});
  const bool done = ImGui::IsItemDeactivatedAfterEdit();
  if (ImGui::IsItemHovered()) w.tooltip("When it was surveyed: growth per year needs it. Empty: as the file or its name says.");
  const std::optional<Date> date = parse_date(date_);
  if (!date_.empty() && !date) {
    w.text("not a date: write 2023-05-04", TextRole::caption, Tone::warning);
    w.record_last("import/date/refused", date_);
  }
  if (!done) return;
  wanted_.no_date = date ? "" : date_;
  if (!date) wanted_.date.reset();
  if (date && (wanted_.date || date != file.date)) wanted_.date = date;
}

void ImportSettingsPanel::draw_system(Widgets& w, const ImportFile& file) {
  const bool plain = file.column("x") != nullptr || file.columns.empty();
  const bool from_file = file.epsg && !file.settings.epsg;
  std::string why_not;
  if (!plain) why_not = file.column("lon") != nullptr ? "Longitude and latitude are projected to their UTM zone" : "Azimuth and distance count from the plot's centre";
  if (plain && from_file) why_not = "The file says it: " + file.system;
  const float width = label(w, "Coordinates") - w.px(22);
  w.input("import/epsg", epsg_, {.hint = "local, or an EPSG code", .width = width, .why_not = why_not});
  const bool done = ImGui::IsItemDeactivatedAfterEdit();
  if (why_not.empty() && ImGui::IsItemHovered()) w.tooltip("The EPSG code of x and y, for example 25832; empty for local coordinates. Alignment needs none.");
  if (done) {
    const int code = std::atoi(epsg_.c_str());
    wanted_.epsg = code > 0 ? std::optional<int>(code) : std::nullopt;
  }
  if (!file.system.empty()) w.text(file.system, TextRole::caption, Tone::secondary);
}

void ImportSettingsPanel::draw_part(Widgets& w, const ImportFile& file) {
  if (file.sheets.size() > 1) {
    const float width = label(w, "Sheet") - w.px(22);
    int at = place_in(file.sheets, file.sheet);
    if (w.combo("import/sheet", file.sheets, at, width)) {
      wanted_ = ImportSettings{.name = wanted_.name, .sheet = file.sheets[static_cast<std::size_t>(at)], .date = wanted_.date, .epsg = wanted_.epsg};
    }
  }
  if (file.plot_columns.empty() || file.plots.empty()) return;
  std::vector<std::string> plots{"all plots"};
  plots.insert(plots.end(), file.plots.begin(), file.plots.end());
  const float width = label(w, "Plot") - w.px(22);
  int plot = file.settings.plot.empty() ? 0 : place_in(plots, file.settings.plot);
  if (w.combo("import/plot", plots, plot, width)) {
    wanted_.plot = plot == 0 ? "" : plots[static_cast<std::size_t>(plot)];
    wanted_.plot_column = plot == 0 ? "" : file.plot_column;
  }
  w.text("by column " + file.plot_column, TextRole::caption, Tone::secondary);
}

void ImportSettingsPanel::draw_scheme(Widgets& w, const ImportFile& file) {
  if (file.column("quadrat") != nullptr && !scheme_) {
    w.paragraph("Positions are put together from quadrats of 20 m and the place in them.", TextRole::table, Tone::secondary);
    return;
  }
  int recognised = 0;
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    if (file.column(schemes[i].kinds[0]) != nullptr) recognised = static_cast<int>(i);
  }
  int at = scheme_.value_or(recognised);
  const float width = label(w, "Position by") - w.px(22);
  if (w.combo("import/scheme", {schemes[0].label, schemes[1].label, schemes[2].label}, at, width)) scheme_ = at;
  const Scheme& scheme = schemes[static_cast<std::size_t>(at)];
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string before = wanted_.columns.contains(scheme.kinds[i]) ? wanted_.columns.at(scheme.kinds[i]) : "";
    draw_column(w, file, scheme.kinds[i], scheme.labels[i], true);
    const auto now = wanted_.columns.find(scheme.kinds[i]);
    if (now == wanted_.columns.end() || now->second == before) continue;
    for (const Scheme& other : schemes) {  // one way to say where a stem stands
      if (&other == &scheme) continue;
      for (const char* kind : other.kinds) wanted_.columns.erase(kind);
    }
  }
}

void ImportSettingsPanel::draw_columns(Widgets& w, const ImportFile& file) {
  w.section("Columns and units");
  draw_scheme(w, file);
  draw_column(w, file, "z", "Ground height", false);
  if (file.column("circumference") == nullptr) draw_column(w, file, "dbh", "DBH", false);
  if (file.column("dbh") == nullptr) draw_column(w, file, "circumference", "Circumference", false);
  draw_column(w, file, "height", "Tree height", false);
  draw_column(w, file, "id", "Stem id", false);
  draw_column(w, file, "species", "Species", false);
  draw_column(w, file, "status", "Status", false);
  draw_column(w, file, "date", "Date", false);
}

void ImportSettingsPanel::draw_column(Widgets& w, const ImportFile& file, const char* kind, const char* text, bool needed) {
  const ImportColumn* column = file.column(kind);
  std::vector<std::string> items{needed ? "choose a column" : "not read"};
  for (std::size_t i = 0; i < file.header.size(); ++i) items.push_back(file.header[i].empty() ? "(column " + std::to_string(i + 1) + ")" : file.header[i]);
  const auto told = wanted_.columns.find(kind);
  const std::string header = column != nullptr ? column->header : told != wanted_.columns.end() ? told->second : "";
  int at = header.empty() ? 0 : std::max(0, place_in(items, header));
  const float room = label(w, text) - w.px(22);
  const bool has_unit = column != nullptr && !units_of(kind).empty();
  const float unit_width = w.px(86);
  const Rect mark{w.next_rect(0, 0).x + room + w.px(4), w.next_rect(0, 0).y, w.px(18), w.px(28)};
  const float column_width = room - (has_unit ? unit_width + w.px(6) : 0.0f);
  if (w.combo(std::string("import/column/") + kind, items, at, column_width)) {
    wanted_.columns[kind] = at == 0 ? "" : items[static_cast<std::size_t>(at)];
    if (at == 0 && needed) wanted_.columns.erase(kind);
  }
  if (has_unit) {
    ImGui::SameLine(0, w.px(6));
    draw_unit(w, file, kind, unit_width);
  }
  if (column == nullptr || !column->guessed) return;
  w.text_in(mark, icon::warning, TextRole::table, Tone::warning, Align::center);
  w.record(std::string("import/guessed/") + kind, mark, column->how);
  if (ImGui::IsMouseHoveringRect({mark.x, mark.y}, {mark.right(), mark.bottom()})) w.tooltip("The unit was guessed (" + column->how + "): choose it to be sure.");
}

void ImportSettingsPanel::draw_unit(Widgets& w, const ImportFile& file, const std::string& kind, float width) {
  std::vector<std::string> words = units_of(kind), labels;
  const ImportColumn* column = file.column(kind);
  if (!column->unit.empty() && place_in(words, column->unit) < 0) words.push_back(column->unit);
  for (const std::string& word : words) labels.push_back(unit_label(word));
  int at = place_in(words, column->unit);
  if (w.combo("import/unit/" + kind, labels, at, width)) wanted_.units[kind] = words[static_cast<std::size_t>(at)];
}

void ImportSettingsPanel::draw_codes(Widgets& w, const ImportFile& file) {
  w.section("Status codes");
  for (const ImportCode& code : file.codes) {
    const float width = w.available_width();
    const Rect row = w.next_rect(width, w.px(28));
    w.text_in({row.x, row.y, w.px(150), row.height}, code.code, TextRole::body, Tone::text);
    w.text_in({row.x + w.px(150), row.y, w.px(84), row.height}, plural(code.rows, "row", "rows"), TextRole::table, Tone::secondary, Align::right);
    ImGui::SetCursorScreenPos({row.x + w.px(246), row.y});
    int at = static_cast<int>(code.meaning);
    if (w.combo("import/code/" + code.code, {"alive", "dead", "unknown", "removed", "not found"}, at, width - w.px(246) - w.px(22))) wanted_.status_codes[code.code] = static_cast<StemStatus>(at);
    if (code.meaning == StemStatus::unknown) w.text_in({row.x + width - w.px(20), row.y, w.px(20), row.height}, icon::warning, TextRole::table, Tone::warning, Align::center);
  }
}

}  // namespace stemwise::ui
