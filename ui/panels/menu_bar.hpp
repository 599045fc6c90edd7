#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// All actions by menu, each with its key and, greyed out, its reason; the project's name and save state at the right.
class MenuBar {
 public:
  void draw(Widgets& w, Frame& frame);
  static constexpr float height = 32.0f;

 private:
  void draw_menu(Widgets& w, Frame& frame, Menu menu);
  void draw_submenu(Widgets& w, Frame& frame, const char* label, ActionId first, ActionId last);
  void draw_item(Widgets& w, Frame& frame, const Action& action);
  void draw_recent(Widgets& w, Frame& frame);
};

/// The submenu that an action stands in; "" for those that stand in their menu itself.
std::string submenu_label(ActionId id);

}  // namespace stemwise::ui
