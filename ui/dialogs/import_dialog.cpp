#include "ui/dialogs/import_dialog.hpp"

#include <imgui.h>

#include <algorithm>

#include "ui/dialogs/modal.hpp"
#include "ui/panels/table_view.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

std::int64_t problem_count(const ImportFile& file) {
  return std::count_if(file.issues.begin(), file.issues.end(), [](const Issue& i) { return i.severity != Severity::note; });
}

std::string state_of(const ImportFile& file) {
  if (file.reading) return "reading…";
  if (!file.settings.take) return "left out";
  if (!file.usable) return "cannot be read like this";
  if (!file.settings.no_date.empty()) return "the date is not understood";
  const std::int64_t problems = problem_count(file);
  return plural(file.stem_count, "stem", "stems") + (problems > 0 ? " · " + plural(problems, "remark", "remarks") : "");
}

/// One column of the rows as they are understood.
struct StemField {
  const char* name;
  float weight;
  bool number;
  std::string (*text)(const Stem&);
};

const std::vector<StemField>& stem_fields() {
  static const auto number = [](std::optional<double> value, double factor, int decimals) { return value ? fixed(*value * factor, decimals) : std::string(dash); };
  static const std::vector<StemField> fields{
      {"Row", 0.6f, true, [](const Stem& s) { return std::to_string(s.source_row); }},
      {"Id", 0.9f, false, [](const Stem& s) { return s.source_id; }},
      {"x, m", 1.2f, true, [](const Stem& s) { return grouped(s.x_m, 2); }},
      {"y, m", 1.2f, true, [](const Stem& s) { return grouped(s.y_m, 2); }},
      {"z, m", 0.8f, true, [](const Stem& s) { return number(s.z_m, 1.0, 2); }},
      {"DBH, cm", 0.9f, true, [](const Stem& s) { return number(s.dbh_m, 100.0, 1); }},
      {"Height, m", 0.9f, true, [](const Stem& s) { return number(s.height_m, 1.0, 1); }},
      {"Species", 1.1f, false, [](const Stem& s) { return s.species; }},
      {"Status", 0.8f, false, [](const Stem& s) { return std::string(to_string(s.status)); }},
      {"Date", 1.1f, false, [](const Stem& s) { return s.date ? to_string(*s.date) : std::string(dash); }}};
  return fields;
}

bool is_shown(const ImportFile& file, const StemField& field) {
  const std::string name = field.name;
  const auto any = [&](const auto& has) { return std::any_of(file.stems.begin(), file.stems.end(), has); };
  if (name == "z, m") return any([](const Stem& s) { return s.z_m.has_value(); });
  if (name == "Height, m") return any([](const Stem& s) { return s.height_m.has_value(); });
  if (name == "Species") return any([](const Stem& s) { return !s.species.empty(); });
  if (name == "Status") return file.column("status") != nullptr;
  if (name == "Date") return any([](const Stem& s) { return s.date.has_value(); });
  return true;
}

}  // namespace

void ImportDialog::draw(Widgets& w, Frame& frame) {
  const std::vector<ImportFile>& files = frame.status.imports;
  if (files.empty()) {
    frame.view.dialog = Dialog::none;
    return;
  }
  bool open = true;
  const Modal modal(w, "Import inventories", 1200.0f, 680.0f, open);
  if (!open) frame.requests.emit(request::ImportFinish{false});
  if (!modal) return;
  shown_ = std::min(shown_, files.size() - 1);
  const float height = ImGui::GetContentRegionAvail().y - w.px(52);
  const float gap = w.px(16);
  const float left = w.px(196), middle = w.px(396);
  draw_files(w, files, left, height);
  ImGui::SameLine(0, gap);
  const ImportFile& file = files[shown_];
  ImGui::BeginChild("settings", {middle, height});
  settings_.draw(w, frame, file, shown_);
  ImGui::EndChild();
  ImGui::SameLine(0, gap);
  ImGui::BeginChild("result", {0, height}, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  draw_result(w, file, height);
  ImGui::EndChild();
  draw_foot(w, frame, files);
}

void ImportDialog::draw_files(Widgets& w, const std::vector<ImportFile>& files, float width, float height) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, w.px(2)});
  ImGui::BeginChild("files", {width, height});
  for (std::size_t i = 0; i < files.size(); ++i) draw_file(w, files[i], i);
  const ImportFile& file = files[std::min(shown_, files.size() - 1)];
  w.section("Recognised");
  for (const std::string& note : file.notes) w.paragraph(note, TextRole::caption, Tone::secondary);
  if (file.remembered) w.paragraph("Columns and units as you chose them for the last file with this header.", TextRole::caption, Tone::accent);
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void ImportDialog::draw_file(Widgets& w, const ImportFile& file, std::size_t index) {
  const Rect row = w.next_rect(w.available_width(), w.px(44));
  if (index == shown_) w.fill(row, w.tokens().accent_soft, w.px(6));
  const std::string state = state_of(file);
  if (w.area("import/file/" + std::to_string(index), row, state)) shown_ = index;
  const bool doubt = !file.usable || problem_count(file) > 0 || !file.settings.no_date.empty();
  const bool out = !file.settings.take;
  const Tone tone = out ? Tone::secondary : !file.usable ? Tone::error : doubt ? Tone::warning : Tone::accent;
  w.text_in({row.x + w.px(6), row.y, w.px(18), row.height}, out ? icon::cross : doubt ? icon::warning : icon::check, TextRole::body, tone, Align::center);
  const float left = row.x + w.px(32), width = row.width - w.px(38);
  w.text_in({left, row.y + w.px(4), width, w.px(19)}, w.middle_shortened(file.file_name, TextRole::strong, width), TextRole::strong, out ? Tone::secondary : Tone::text);
  w.text_in({left, row.y + w.px(23), width, w.px(16)}, state, TextRole::caption, Tone::secondary);
  if (ImGui::IsMouseHoveringRect({row.x, row.y}, {row.right(), row.bottom()})) w.tooltip(file.path);
}

void ImportDialog::draw_result(Widgets& w, const ImportFile& file, float height) {
  const float problems = file.issues.empty() ? w.px(64) : std::min(0.46f * height, w.px(64 + 28.0f * static_cast<float>(file.issues.size())));
  draw_rows(w, file, height - problems);
  draw_problems(w, file, problems);
}

void ImportDialog::draw_rows(Widgets& w, const ImportFile& file, float height) {
  const Rect head = w.next_rect(w.available_width(), w.px(28));
  const bool raw = as_in_file_ || file.stems.empty();
  const float width = w.px(104);
  w.text_in({head.x, head.y, head.width - 2 * width - w.px(8), head.height}, file.format.empty() ? "First rows" : "First rows · " + file.format, TextRole::head, Tone::text);
  if (w.button_in({head.right() - 2 * width, head.y, width, head.height}, "import/understood", "Understood", {.quiet = raw, .active = !raw, .tooltip = "The stems as they will be in the project"})) as_in_file_ = false;
  if (w.button_in({head.right() - width, head.y, width, head.height}, "import/raw", "In the file", {.quiet = !raw, .active = raw, .tooltip = "The rows as the file has them"})) as_in_file_ = true;
  ImGui::SetCursorScreenPos({head.x, head.bottom() + w.px(4)});
  ImGui::BeginChild("rows", {0, height - w.px(36)}, false, ImGuiWindowFlags_HorizontalScrollbar);
  TableView table;
  std::vector<const StemField*> fields;
  for (const StemField& field : stem_fields()) {
    if (!raw && is_shown(file, field)) fields.push_back(&field);
  }
  table.path = raw ? "import/rows/raw" : "import/rows/understood";
  if (raw) {
    table.columns.push_back({"Row", 0.6f, true});
    for (std::size_t i = 0; i < file.header.size(); ++i) table.columns.push_back({file.header[i].empty() ? std::to_string(i + 1) : file.header[i]});
    table.rows = file.header.empty() ? 0 : file.rows.size();
    table.least_width = w.px(84) * static_cast<float>(table.columns.size());
    table.cell = [&](std::size_t row, std::size_t column) -> TableCell {
      if (column == 0) return {std::to_string(file.row_numbers[row]), Tone::secondary};
      return {column - 1 < file.rows[row].size() ? file.rows[row][column - 1] : ""};
    };
  } else {
    for (const StemField* field : fields) table.columns.push_back({field->name, field->weight, field->number});
    table.rows = file.stems.size();
    table.cell = [&](std::size_t row, std::size_t column) -> TableCell { return {fields[column]->text(file.stems[row]), column == 0 ? Tone::secondary : Tone::text}; };
  }
  table.empty_text = "No rows to show: what stands in the way is told below.";
  draw_table(w, table);
  ImGui::EndChild();
}

void ImportDialog::draw_problems(Widgets& w, const ImportFile& file, float height) {
  const Rect head = w.next_rect(w.available_width(), w.px(28));
  const std::int64_t count = problem_count(file);
  w.text_in(head, count == 0 ? "No problems" : plural(count, "remark", "remarks"), TextRole::head, count == 0 ? Tone::accent : Tone::text);
  w.record("import/problems", head, std::to_string(count));
  ImGui::Dummy({head.width, head.height});
  if (file.issues.empty()) {
    w.text("Every row is understood.", TextRole::body, Tone::secondary);
    return;
  }
  ImGui::BeginChild("problems", {0, height - w.px(36)});
  TableView table;
  table.path = "import/problem";
  table.columns = {{"Row", 0.5f, true}, {"Column", 1.0f}, {"What", 5.0f}};
  table.rows = file.issues.size();
  table.cell = [&](std::size_t row, std::size_t column) -> TableCell {
    const Issue& issue = file.issues[row];
    const Tone tone = issue.severity == Severity::error ? Tone::error : Tone::text;
    if (column == 0) return {issue.row > 0 ? std::to_string(issue.row) : dash, Tone::secondary};
    if (column == 1) return {issue.column.empty() ? dash : issue.column, tone};
    return {issue.text + (issue.help.empty() ? "" : " (" + issue.help + ")"), tone};
  };
  draw_table(w, table);
  ImGui::EndChild();
}

void ImportDialog::draw_foot(Widgets& w, Frame& frame, const std::vector<ImportFile>& files) {
  const ImportFile& file = files[shown_];
  w.gap(12);
  const Rect row = w.next_rect(w.available_width(), w.px(30));
  const auto wanted = std::count_if(files.begin(), files.end(), [](const ImportFile& f) { return f.usable && f.settings.take; });
  const bool reading = std::any_of(files.begin(), files.end(), [](const ImportFile& f) { return f.reading; });
  const std::string label = "Add " + plural(wanted, "inventory", "inventories");
  const float add = w.text_width(label, TextRole::strong) + w.px(40), cancel = w.px(90);
  const auto undated = std::find_if(files.begin(), files.end(), [](const ImportFile& f) { return f.settings.take && !f.settings.no_date.empty(); });
  std::string why_not = reading ? "Wait until the file is read" : wanted == 0 ? "No file can be read like this" : "";
  if (undated != files.end()) why_not = "\"" + undated->settings.no_date + "\" is not a date (" + undated->file_name + "): write 2023-05-04, or leave it empty";
  bool take = file.settings.take;
  if (w.checkbox("import/take", "Take this file", take, "Off: the file is left out")) {
    ImportSettings settings = file.settings;
    settings.take = take;
    frame.requests.emit(request::ImportEdit{shown_, settings});
  }
  if (!file.command_line.empty()) {
    const float left = row.x + w.px(160);
    w.text_in({left, row.y, row.right() - add - cancel - w.px(40) - left, w.px(24)}, "On the command line: " + file.command_line, TextRole::caption, Tone::secondary);
  }
  if (w.button_in({row.right() - add - cancel - w.px(10), row.y, cancel, row.height}, "import/cancel", "Cancel")) frame.requests.emit(request::ImportFinish{false});
  if (w.button_in({row.right() - add, row.y, add, row.height}, "import/add", label, {.primary = true, .why_not = why_not})) frame.requests.emit(request::ImportFinish{true});
}

}  // namespace stemwise::ui
