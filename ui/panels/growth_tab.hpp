#pragma once
#include <string>
#include <vector>

#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// DBH classes per survey, the distribution of DBH change with its 20-80 % band, and the figures per pair of surveys.
class GrowthTab {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  struct Bars {
    std::vector<std::vector<int>> series;  ///< counts per series and class
    std::vector<Color> colors;
    std::vector<std::string> labels;       ///< per class, for hover
    double low = 0.0, step = 1.0;          ///< of the classes' lower limits
  };
  void collect(const Frame& frame);
  void draw_figures(Widgets& w, const Frame& frame);
  void draw_bars(Widgets& w, const Rect& rect, const Bars& bars, const std::string& title, const std::string& unit, const GrowthRow* band);

  std::uint64_t revision_ = ~0ULL;
  Bars classes_;
  Bars change_;
};

}  // namespace stemwise::ui
