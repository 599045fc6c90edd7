#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The ways out when a survey could not be aligned: two pairs of stems that a person knows, or a rough position.
class RescueForm {
 public:
  void draw(Widgets& w, Frame& frame, const Inventory& inventory);

 private:
  void draw_pairs(Widgets& w, Frame& frame, const Inventory& inventory);
  void draw_position(Widgets& w, Frame& frame, const Inventory& inventory);

  bool position_open_ = false;
  double x_m_ = 0.0, y_m_ = 0.0, yaw_deg_ = 0.0, radius_m_ = 10.0;
};

}  // namespace stemwise::ui
