#pragma once
#include <memory>

#include "ui/frame.hpp"
#include "ui/geometry.hpp"
#include "ui/widgets/registry.hpp"

namespace stemwise::ui {

/// The whole window: all panels and dialogs in the current ImGui context.
class Shell {
 public:
  Shell();
  ~Shell();

  /// Loads fonts and sets the style where theme or scale changed. True when the font texture has to be made anew.
  /// Before ImGui::NewFrame.
  bool prepare(const ViewState& view, float scale);
  /// Right before ImGui::NewFrame, with the frame's input in place: which of Dear ImGui's own keys mean something else here.
  void take_keys();
  /// The text field that is being typed in is left: what stands there is answered after the next frame.
  void leave_field();
  /// Between ImGui::NewFrame and ImGui::Render.
  void draw(Frame& frame);

  const WidgetRegistry& registry() const;
  const std::string& focused() const;  ///< the control that has the keyboard, by its path; "" for none
  /// Where the map or 3D view goes, in pixels; empty while something else is there. Known after the first draw.
  Rect viewport_rect() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace stemwise::ui
