#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// What to do first: shown while the project has no inventory.
class EmptyState {
 public:
  void draw(Widgets& w, Frame& frame, const Rect& rect);

 private:
  void draw_actions(Widgets& w, Frame& frame, const Rect& column);
  void draw_recent(Widgets& w, Frame& frame, const Rect& column);
};

}  // namespace stemwise::ui
