#pragma once
#include <string>
#include <vector>

namespace stemwise::ui {

/// Tab goes through every control in the order in which they are drawn, Shift and Tab back; while a dialog is open through its
/// own ones. (Dear ImGui 1.86 lets Tab go through text fields only.)
class FocusOrder {
 public:
  void begin_frame();
  /// After an item of Dear ImGui: takes its place in the order, and gets the focus where Tab has come to it; a field for text is
  /// then written in at once.
  void visit(const std::string& path, bool is_text);
  void move(bool forward);
  void go_to(const std::string& path) { wanted_ = path; }  ///< when it is drawn next
  const std::string& focused() const { return focused_; }  ///< of the last frame; "" for none

 private:
  std::vector<std::string> order_, drawn_;  ///< of the last frame, and of this one so far
  std::string focused_, focused_now_, wanted_;
  std::string place_, place_now_;  ///< where Tab goes on from: also what was clicked last
};

}  // namespace stemwise::ui
