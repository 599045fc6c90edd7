#include "ui/panels/inventory_details.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/geometry/polygon.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {
namespace {

const char* role_of(const ProjectState& state, InventoryId id) {
  if (id == state.reference) return "The reference: all others are aligned to it";
  if (state.is_placed(id)) return "Aligned to the reference";
  const auto tried = state.alignments.find(id);
  if (tried == state.alignments.end() || tried->second.status == AlignmentStatus::unaligned) return "Not aligned to the reference yet";
  return tried->second.status == AlignmentStatus::probable ? "Has a probable pose that waits for a decision, in step 2" : "Could not be aligned: step 2 says why";
}

}  // namespace

void InventoryDetails::draw(Widgets& w, Frame& frame) {
  const ProjectState& state = frame.state();
  const Inventory* inventory = state.find(frame.view.selected_inventory);
  if (inventory == nullptr) inventory = state.find(state.reference);
  if (inventory == nullptr) return;
  w.text(inventory->name, TextRole::title);
  w.record_last("details/name", inventory->name);
  w.text(role_of(state, inventory->id), TextRole::table, Tone::secondary);
  if (counts_.id != inventory->id || counts_.revision != frame.revision) {
    count(*inventory);
    counts_.revision = frame.revision;
  }
  draw_facts(w, *inventory);
  draw_date(w, frame, *inventory);
  draw_coverage(w, frame, *inventory);
  draw_dbh_error(w, frame, *inventory);
  w.section("How it was read");
  for (const std::string& note : inventory->source.notes) w.paragraph(note, TextRole::table, Tone::secondary);
  if (inventory->source.notes.empty()) w.text("No notes.", TextRole::table, Tone::secondary);
  draw_first_rows(w, *inventory);
  w.gap(12);
  frame.view.selected_inventory = inventory->id;
  w.action_button("details/make_reference", ActionId::edit_make_reference, frame.available, frame.requests, {.width = -1.0f});
  w.action_button("details/remove", ActionId::edit_remove_inventory, frame.available, frame.requests, {.width = -1.0f});
  w.gap(8);
  const bool enough = state.inventories.size() >= 2;
  if (enough && w.button("details/next", "Go on to align", {.primary = true, .width = -1.0f, .key = "2"})) frame.requests.run(ActionId::step_align);
  if (!enough) w.paragraph("Add at least one more survey of the same forest to align.", TextRole::table, Tone::secondary);
}

void InventoryDetails::count(const Inventory& inventory) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  counts_ = {~0ULL, inventory.id, 0, 0, 0, 0, inf, -inf, inf, -inf, 0.0};
  for (const Stem& s : inventory.stems) {
    counts_.with_dbh += s.dbh_m ? 1 : 0;
    counts_.with_z += s.z_m ? 1 : 0;
    counts_.with_axis += s.axis ? 1 : 0;
    counts_.reconstructed += s.reconstructed ? 1 : 0;
    counts_.mean_dbh_m += s.dbh_m.value_or(0.0);
    counts_.min_x = std::min(counts_.min_x, s.x_m);
    counts_.max_x = std::max(counts_.max_x, s.x_m);
    counts_.min_y = std::min(counts_.min_y, s.y_m);
    counts_.max_y = std::max(counts_.max_y, s.y_m);
  }
  if (counts_.with_dbh > 0) counts_.mean_dbh_m /= static_cast<double>(counts_.with_dbh);
}

void InventoryDetails::draw_facts(Widgets& w, const Inventory& inventory) {
  const auto total = static_cast<double>(std::max<std::size_t>(inventory.stems.size(), 1));
  const auto share = [&](std::size_t n) { return count_text(static_cast<std::int64_t>(n)) + " (" + percent_text(static_cast<double>(n) / total) + ")"; };
  w.gap(8);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  w.fact("details/format", "Format", inventory.source.format);
  if (!inventory.source.path.empty()) w.fact("details/file", "File", inventory.source.path, inventory.source.path);
  w.fact("details/stems", "Stems", count_text(static_cast<std::int64_t>(inventory.stems.size())));
  w.fact("details/dbh", "With a measured DBH", share(counts_.with_dbh));
  if (counts_.with_dbh > 0) w.fact("details/mean_dbh", "Mean DBH", dbh_text(counts_.mean_dbh_m) + " cm");
  w.fact("details/z", "With a height of the base", share(counts_.with_z));
  w.fact("details/axis", "With a stem axis", share(counts_.with_axis));
  w.fact("details/extent", "Extent", fixed(counts_.max_x - counts_.min_x, 0) + " × " + fixed(counts_.max_y - counts_.min_y, 0) + " m");
  if (inventory.frames) w.fact("details/frames", "Frames", count_text(static_cast<std::int64_t>(inventory.frames->frames.size())));
  if (inventory.source.epsg) w.fact("details/crs", "CRS", "EPSG:" + std::to_string(*inventory.source.epsg));
  ImGui::PopStyleVar();
}

void InventoryDetails::fill_date(const Frame& frame, const Inventory& inventory) {
  if (refused_in_ != &frame.project) refused_.clear();  // another project's surveys have the same ids
  refused_in_ = &frame.project;
  if (dated_ == inventory.id && dated_at_ == frame.revision) return;
  dated_ = inventory.id;
  dated_at_ = frame.revision;
  const auto refused = refused_.find(inventory.id);
  if (refused != refused_.end() && refused->second.instead_of != inventory.date) refused_.erase(refused);
  date_ = refused_.contains(inventory.id) ? refused_.at(inventory.id).text : inventory.date ? to_string(*inventory.date) : "";
}

void InventoryDetails::draw_date(Widgets& w, Frame& frame, const Inventory& inventory) {
  fill_date(frame, inventory);
  w.section("Date of the survey");
  w.input("details/date", date_, {.hint = "2023-05-04, or a year"});
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    const std::optional<Date> date = parse_date(date_);
    refused_.erase(inventory.id);
    if (!date && !date_.empty()) refused_[inventory.id] = {date_, inventory.date};
    else if (date != inventory.date) frame.requests.emit(request::SetDate{inventory.id, date});
  }
  const auto refused = refused_.find(inventory.id);
  if (refused != refused_.end()) {
    w.paragraph("\"" + refused->second.text + "\" is not a date. Write it as 2023-05-04.", TextRole::table, Tone::warning);
    w.record_last("details/date/refused", refused->second.text);
  } else if (!inventory.date) {
    w.paragraph("Without a date there are no growth rates per year.", TextRole::table, Tone::secondary);
  }
}

/// Where the survey looked: what is not there outside of it is never called missing.
void InventoryDetails::draw_coverage(Widgets& w, Frame& frame, const Inventory& inventory) {
  const auto it = frame.state().coverages.find(inventory.id);
  if (it == frame.state().coverages.end()) return;
  static constexpr const char* sources[] = {"from the outline of the stems", "from what the frames saw", "drawn by hand"};
  const Coverage& coverage = it->second;
  w.section("Coverage");
  const std::string words = fixed(area_sq_m(coverage.in_inventory) / 1e4, 3) + " ha, " + sources[static_cast<std::size_t>(coverage.source)];
  w.paragraph(words, TextRole::table, Tone::secondary);
  w.record_last("details/coverage", words);
  frame.view.selected_inventory = inventory.id;
  w.action_button("details/draw_coverage", ActionId::edit_coverage, frame.available, frame.requests, {.active = frame.view.tool == Tool::coverage, .width = -1.0f});
  if (coverage.source == CoverageSource::drawn && w.button("details/estimate_coverage", "Estimate it again", {.width = -1.0f})) frame.requests.emit(request::EstimateCoverage{inventory.id});
}

/// One measurement's error: estimated from the matched stems unless a person knows better.
void InventoryDetails::draw_dbh_error(Widgets& w, Frame& frame, const Inventory& inventory) {
  const auto set = frame.state().dbh_error_m.find(inventory.id);
  const bool known = set != frame.state().dbh_error_m.end();
  if (errors_of_ != inventory.id || errors_at_ != frame.revision) {
    errors_of_ = inventory.id;
    errors_at_ = frame.revision;
    error_cm_ = known ? set->second * 100.0 : 0.0;
  }
  w.section("DBH error of one measurement");
  const Rect row = w.next_rect(w.available_width(), w.px(28));
  w.text_in({row.x, row.y, row.width * 0.6f, row.height}, "Standard deviation, cm", TextRole::body, Tone::secondary);
  ImGui::SetCursorScreenPos({row.x + row.width * 0.62f, row.y});
  w.number("details/dbh_error", error_cm_, "%.2f", 0.0f, "from matches");
  const bool left = ImGui::IsItemDeactivatedAfterEdit();
  const bool possible = error_cm_ >= 0.0 && error_cm_ <= 50.0;
  if (!possible) w.paragraph("An error lies between 0 and 50 cm: this one is not taken.", TextRole::table, Tone::warning);
  if (!left || !possible) return;
  frame.requests.emit(request::SetDbhError{inventory.id, error_cm_ == 0.0 ? std::nullopt : std::optional(error_cm_ / 100.0)});
}

void InventoryDetails::draw_first_rows(Widgets& w, const Inventory& inventory) {
  w.section("First rows as understood");
  const std::size_t rows = std::min<std::size_t>(inventory.stems.size(), 5);
  const auto text_of = [&](std::size_t r, std::size_t c) -> std::string {
    static constexpr const char* names[] = {"Id", "x, m", "y, m", "DBH, cm", "Species"};
    if (r == 0) return names[c];
    const Stem& s = inventory.stems[r - 1];
    switch (c) {
      case 0: return s.source_id;
      case 1: return grouped(s.x_m, 2);
      case 2: return grouped(s.y_m, 2);
      case 3: return dbh_text(s.dbh_m);
      default: return s.species.empty() ? dash : s.species;
    }
  };
  // Numbers get the width they need, also those of UTM; ids and species share the rest.
  std::array<float, 5> widths{};
  for (std::size_t c = 1; c < 4; ++c) {
    for (std::size_t r = 0; r <= rows; ++r) widths[c] = std::max(widths[c], w.text_width(text_of(r, c), r == 0 ? TextRole::caption : TextRole::table) + w.px(9));
  }
  const float rest = std::max(w.px(60), w.available_width() - widths[1] - widths[2] - widths[3]);
  widths[0] = 0.34f * rest;
  widths[4] = 0.66f * rest;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (std::size_t r = 0; r <= rows; ++r) {
    const Rect line = w.next_rect(w.available_width(), w.px(22));
    float x = line.x;
    for (std::size_t c = 0; c < 5; ++c) {
      const bool number = c > 0 && c < 4;
      const Rect cell{x + (c == 4 ? w.px(9) : 0.0f), line.y, widths[c] - (c == 4 ? w.px(9) : number ? 0.0f : w.px(2)), line.height};
      w.text_in(cell, text_of(r, c), r == 0 ? TextRole::caption : TextRole::table, r == 0 ? Tone::secondary : Tone::text, number ? Align::right : Align::left);
      x += widths[c];
    }
    if (r > 0) w.hairline(line.x, line.y, line.right(), line.y + 1);
    ImGui::Dummy({line.width, line.height});
  }
  ImGui::PopStyleVar();
}

}  // namespace stemwise::ui
