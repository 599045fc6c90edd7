#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The five steps with what is done in each, and the search box.
class StepBar {
 public:
  void draw(Widgets& w, Frame& frame, const Rect& rect);
  static constexpr float height = 52.0f;

 private:
  struct StepText {
    std::string title;
    std::string state;
    bool done = false;
  };
  StepText text_of(const Frame& frame, Step step) const;
  void draw_step(Widgets& w, Frame& frame, Step step, const StepText& text, const Rect& rect);
};

}  // namespace stemwise::ui
