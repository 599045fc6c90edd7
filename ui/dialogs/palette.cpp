#include "ui/dialogs/palette.hpp"

#include <imgui.h>

#include <algorithm>
#include <cctype>

#include "ui/dialogs/modal.hpp"

namespace stemwise::ui {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Every word of the query begins somewhere in the text.
bool matches(const std::string& query, const std::string& text) {
  std::size_t start = 0;
  while (start < query.size()) {
    const std::size_t end = std::min(query.find(' ', start), query.size());
    if (text.find(query.substr(start, end - start)) == std::string::npos) return false;
    start = end + 1;
  }
  return true;
}

}  // namespace

std::vector<Palette::Hit> Palette::hits(const Frame& frame) const {
  std::vector<Hit> found;
  const std::string query = lower(query_);
  const auto digits = query.find_first_of("0123456789");
  if (digits != std::string::npos) {
    const TreeId tree{std::strtoll(query.c_str() + digits, nullptr, 10)};
    if (frame.derived.tree(tree) != nullptr) found.push_back({std::nullopt, tree});
  }
  for (const Action& a : all_actions()) {
    if (a.id != ActionId::help_palette && matches(query, lower(std::string(a.label) + " " + a.help + " " + menu_label(a.menu)))) found.push_back({a.id, {}});
  }
  return found;
}

void Palette::run(Frame& frame, const Hit& hit) {
  frame.view.dialog = Dialog::none;
  if (hit.action) {
    frame.requests.run(*hit.action);
  } else {
    frame.requests.emit(request::SelectTree{hit.tree});
  }
}

void Palette::draw(Widgets& w, Frame& frame) {
  bool open = true;
  const float rows = static_cast<float>(std::max<std::size_t>(shown_, 1));
  const Modal modal(w, "Search or run a command", 560.0f, std::min(460.0f, 104.0f + 30.0f * rows), open, Modal::Place::top);
  if (!modal) return;
  if (fresh_) {
    query_.clear();
    at_ = 0;
    ImGui::SetKeyboardFocusHere();
    fresh_ = false;
  }
  if (w.input("palette/query", query_, {.hint = "An action, or a tree's number"})) at_ = 0;
  const std::vector<Hit> found = hits(frame);
  shown_ = found.size();
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) at_ = std::min(at_ + 1, found.empty() ? 0 : found.size() - 1);
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow)) && at_ > 0) --at_;
  ImGui::BeginChild("hits", {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (std::size_t i = 0; i < found.size(); ++i) draw_hit(w, frame, found[i], i);
  if (found.empty()) w.text("Nothing is called that.", TextRole::body, Tone::secondary);
  ImGui::PopStyleVar();
  ImGui::EndChild();
  const bool enter = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
  if (enter && at_ < found.size() && (!found[at_].action || frame.can(*found[at_].action))) run(frame, found[at_]);
  if (!open) frame.view.dialog = Dialog::none;
  if (frame.view.dialog != Dialog::palette) {
    fresh_ = true;
    ImGui::CloseCurrentPopup();
  }
}

void Palette::draw_hit(Widgets& w, Frame& frame, const Hit& hit, std::size_t place) {
  const Rect row = w.next_rect(w.available_width(), w.px(30));
  if (place == at_) {
    w.fill(row, w.tokens().accent_soft, w.px(6));
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow)) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow))) ImGui::SetScrollHereY();
  }
  const std::string why_not = hit.action ? frame.available[static_cast<std::size_t>(*hit.action)].why_not : "";
  const std::string label = hit.action ? action(*hit.action).label : "Go to " + tree_label(hit.tree);
  const std::string path = hit.action ? action(*hit.action).name : "tree";
  if (w.area("palette/" + path, row, label) && why_not.empty()) run(frame, hit);
  if (ImGui::IsItemHovered()) w.tooltip(!why_not.empty() ? why_not : hit.action ? action(*hit.action).help : "Selects the tree and flies to it");
  const Rect inner{row.x + w.px(10), row.y, row.width - w.px(20), row.height};
  w.text_in(inner, label, TextRole::body, why_not.empty() ? Tone::text : Tone::faint);
  if (hit.action) w.text_in(inner, to_string(action(*hit.action).chord), TextRole::caption, Tone::secondary, Align::right);
}

}  // namespace stemwise::ui
