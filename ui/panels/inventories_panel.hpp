#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The surveys as cards, the fates with their counts, what colours mean, and how the selected survey was aligned.
class InventoriesPanel {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_head(Widgets& w, Frame& frame);
  void draw_card(Widgets& w, Frame& frame, const Inventory& inventory);
  void draw_eye(Widgets& w, Frame& frame, const Inventory& inventory, const Rect& card);
  void draw_fates(Widgets& w, Frame& frame);
  void draw_fate(Widgets& w, Frame& frame, Fate fate, int count);
  void draw_view_choices(Widgets& w, Frame& frame);
  void draw_compare(Widgets& w, Frame& frame);
  void draw_alignment(Widgets& w, Frame& frame);
};

/// The shape and colour of a fate, as on the map.
void draw_fate_mark(Widgets& w, Fate fate, float x, float y, float radius_px);

}  // namespace stemwise::ui
