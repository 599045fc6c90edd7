#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Jobs with stage, progress and outcome at the left; notices with every detail at the right.
class JobsTab {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_job(Widgets& w, Frame& frame, const JobView& job);
  void draw_notice(Widgets& w, Frame& frame, const Notice& notice);
};

}  // namespace stemwise::ui
