#pragma once
#include <array>
#include <cstdint>
#include <string>

namespace stemwise::ui {

enum class Chart { tree_history, dbh_classes, growth_distribution, growth_against_dbh, residuals, residual_rose };
inline constexpr std::size_t chart_count = 6;

/// "dbh-classes": for file names.
const char* chart_word(Chart chart);
/// "DBH classes": for people.
const char* chart_label(Chart chart);

/// A painted chart as a GL texture (first row on top), and what the mouse is over in it.
struct ChartView {
  std::uint64_t texture = 0;
  int width_px = 0;
  int height_px = 0;
  std::string tip;
};
using ChartViews = std::array<ChartView, chart_count>;

}  // namespace stemwise::ui
