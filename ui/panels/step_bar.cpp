#include "ui/panels/step_bar.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/text/format.hpp"
#include "ui/text/georeference_words.hpp"

namespace stemwise::ui {
namespace {

struct AlignCount {
  int placed = 0, refused = 0, others = 0;
};

AlignCount count_aligned(const ProjectState& state) {
  AlignCount n;
  for (const auto& inventory : state.inventories) {
    if (inventory->id == state.reference) continue;
    ++n.others;
    n.placed += state.is_placed(inventory->id) ? 1 : 0;
    const auto it = state.alignments.find(inventory->id);
    n.refused += it != state.alignments.end() && it->second.status == AlignmentStatus::failed ? 1 : 0;
  }
  return n;
}

std::string align_state(const AlignCount& n) {
  if (n.others == 0) return "needs two surveys";
  if (n.placed == n.others) return "all aligned";
  if (n.refused > 0) return std::to_string(n.refused) + " of " + std::to_string(n.others) + " refused";
  return n.placed == 0 ? "not aligned yet" : std::to_string(n.placed) + " of " + std::to_string(n.others) + " aligned";
}

}  // namespace

StepBar::StepText StepBar::text_of(const Frame& frame, Step step) const {
  const ProjectState& state = frame.state();
  const auto surveys = static_cast<std::int64_t>(state.inventories.size());
  const auto doubtful = static_cast<int>(frame.tables().queue.size());
  const AlignCount aligned = count_aligned(state);
  switch (step) {
    case Step::inventories: return {"Inventories", surveys == 0 ? "none yet" : plural(surveys, "survey", "surveys"), surveys >= 2};
    case Step::align: return {"Align", align_state(aligned), aligned.others > 0 && aligned.placed == aligned.others};
    case Step::review: {
      if (aligned.placed == 0) return {"Review", "after alignment", false};
      if (doubtful == 0) return {"Review", "nothing in doubt", true};
      return {"Review", count_text(frame.derived.decided) + " of " + count_text(doubtful) + " decided", frame.derived.decided == doubtful};
    }
    case Step::merge: {
      const bool placed = state.georeference.kind != GeoreferenceKind::none;
      return {"Merge and georeference", placed ? crs_words(state.georeference) : "local coordinates", placed};
    }
    case Step::report: return {"Report and export", "trees, matches, growth", false};
  }
  return {};
}

void StepBar::draw(Widgets& w, Frame& frame, const Rect& rect) {
  w.fill(rect, w.tokens().panel);
  w.hairline(rect.x, rect.bottom() - 1, rect.right(), rect.bottom());
  const float search_width = w.px(206);
  const float margin = w.px(16);
  std::array<StepText, 5> texts;
  std::array<float, 5> widths{};
  float total = 0.0f;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    texts[i] = text_of(frame, static_cast<Step>(i + 1));
    widths[i] = w.px(52) + std::max(w.text_width(texts[i].title, TextRole::head), w.text_width(texts[i].state, TextRole::caption));
    total += widths[i];
  }
  const float room = rect.width - search_width - 3 * margin;
  const float spare = std::clamp((room - total) / 5.0f, -w.px(40), w.px(52));
  float x = rect.x + w.px(12);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const float width = widths[i] + spare;
    draw_step(w, frame, static_cast<Step>(i + 1), texts[i], {x, rect.y + w.px(6), width - w.px(4), rect.height - w.px(12)});
    x += width;
  }
  const Rect search{rect.right() - margin - search_width, rect.y + w.px(12), search_width, w.px(28)};
  w.fill(search, w.tokens().canvas, w.px(6));
  w.outline(search, w.tokens().line, w.px(6));
  if (w.area("steps/search", search, "")) frame.requests.run(ActionId::help_palette);
  w.text_in({search.x + w.px(11), search.y, search.width - w.px(62), search.height}, "Search or run a command", TextRole::caption, Tone::secondary);
  w.text_in({search.x, search.y, search.width - w.px(11), search.height}, "Ctrl+P", TextRole::caption, Tone::secondary, Align::right);
}

void StepBar::draw_step(Widgets& w, Frame& frame, Step step, const StepText& text, const Rect& rect) {
  const bool current = frame.view.step == step;
  const Tokens& t = w.tokens();
  if (current) w.fill(rect, t.accent_soft, w.px(6));
  const auto number = std::to_string(static_cast<int>(step));
  const auto id = static_cast<ActionId>(static_cast<int>(ActionId::step_inventories) + static_cast<int>(step) - 1);
  if (w.area("steps/" + number, rect, text.state)) frame.requests.run(id);
  if (ImGui::IsItemHovered()) w.tooltip_at(rect.x, rect.bottom() + w.px(8), std::string(action(id).help) + "  (" + number + ")");

  const float radius = w.px(12);
  const ImVec2 center{rect.x + w.px(10) + radius, rect.center_y()};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const Rect disc{center.x - radius, center.y - radius, 2 * radius, 2 * radius};
  if (text.done && !current) {
    draw->AddCircleFilled(center, radius, t.accent.packed(), 32);
    w.text_in(disc, icon::check, TextRole::caption, Tone::on_accent, Align::center);
  } else {
    const Color ring = current ? t.accent : t.faint;
    draw->AddCircle(center, radius - 0.5f, ring.packed(), 32, w.px(1.5f));
    w.text_in(disc, number, TextRole::strong, current ? Tone::accent : Tone::secondary, Align::center);
  }
  const float left = center.x + radius + w.px(9);
  const float width = rect.right() - left - w.px(4);
  w.text_in({left, rect.y + w.px(2), width, w.px(19)}, text.title, TextRole::head, current || text.done ? Tone::text : Tone::secondary);
  w.text_in({left, rect.y + w.px(20), width, w.px(16)}, text.state, TextRole::caption, Tone::secondary);
}

}  // namespace stemwise::ui
