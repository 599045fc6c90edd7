#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The figures per pair of surveys, and the charts: DBH classes, DBH change with its 20-80 % band, change against DBH,
/// residuals and their directions; as many beside each other as there is room for.
class GrowthTab {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_figures(Widgets& w, Frame& frame);
  void draw_pair(Widgets& w, Frame& frame, std::size_t index);
  void draw_charts(Widgets& w, Frame& frame, const Rect& area);
};

}  // namespace stemwise::ui
