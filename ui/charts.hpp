#pragma once
#include <array>
#include <cstdint>
#include <string>

namespace stemwise::ui {

enum class Chart { tree_history, dbh_classes, growth_distribution, growth_against_dbh, residuals };
inline constexpr std::size_t chart_count = 5;

/// A painted chart as a GL texture (first row on top), and what the mouse is over in it.
struct ChartView {
  std::uint64_t texture = 0;
  int width_px = 0;
  int height_px = 0;
  std::string tip;
};
using ChartViews = std::array<ChartView, chart_count>;

}  // namespace stemwise::ui
