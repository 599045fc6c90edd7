#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The figures per pair of surveys, and the charts: DBH classes, DBH change with its 20-80 % band, change against DBH,
/// residuals.
class GrowthTab {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_figures(Widgets& w, const Frame& frame);
};

}  // namespace stemwise::ui
