#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Cursor coordinates (local, projected, geographic), the running job with cancel, notices.
class StatusBar {
 public:
  void draw(Widgets& w, Frame& frame, const Rect& rect);
  static constexpr float height = 29.0f;

 private:
  float draw_job(Widgets& w, Frame& frame, const Rect& rect, float right);
  void draw_coordinates(Widgets& w, const Frame& frame, const Rect& rect, float right);
  float draw_notices(Widgets& w, Frame& frame, const Rect& rect);
};

}  // namespace stemwise::ui
