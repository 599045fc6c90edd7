#pragma once
#include "ui/frame.hpp"
#include "ui/panels/rescue_form.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Step 2, right: one button, the result per survey with its reasons, and the ways out of a refusal.
class AlignPanel {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_run(Widgets& w, Frame& frame);
  void draw_last_run(Widgets& w, const Frame& frame);
  void draw_settings(Widgets& w, Frame& frame);
  void draw_result(Widgets& w, Frame& frame, const Inventory& inventory);
  void draw_given_position(Widgets& w, Frame& frame, const Inventory& inventory);
  void draw_looks(Widgets& w, Frame& frame, const Inventory& inventory, const InventoryAlignment& alignment);

  bool settings_open_ = false;
  bool rescue_open_ = false;
  RescueForm rescue_;
};

}  // namespace stemwise::ui
