#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The map or the 3D view: `app`'s picture, our tools on top of it; hands the mouse on.
class ViewportPanel {
 public:
  void draw(Widgets& w, Frame& frame, const Rect& rect);

 private:
  void draw_picture(Widgets& w, Frame& frame, const Rect& rect);
  void draw_later(Widgets& w, Frame& frame, const Rect& rect);
  void send_pointer(Frame& frame, const Rect& rect);
  void draw_tools(Widgets& w, Frame& frame, const Rect& rect);
  void draw_layers(Widgets& w, Frame& frame, const Rect& button);
  void draw_hover(Widgets& w, Frame& frame, const Rect& rect);
  void draw_lines(Widgets& w, Frame& frame, const Rect& rect);
  void run_shape_keys(Frame& frame);
  void draw_selection_box(Widgets& w, Frame& frame, const Rect& rect);
  void draw_over_picture(Widgets& w, Frame& frame, const Rect& rect);
  void draw_banner(Widgets& w, Frame& frame, const Rect& rect);

  float press_x_ = 0.0f, press_y_ = 0.0f;
  bool moved_ = false;
};

}  // namespace stemwise::ui
