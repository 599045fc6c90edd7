#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/project/project_state.hpp"
#include "core/survey/tables.hpp"

namespace stemwise {

// Charts as plain values, made from the tables in one place: the window, the report and the files show the same figures.
// Who paints them knows nothing of forests; who makes them knows nothing of pixels. Values are in the axis' unit.

/// What a colour means; the painter's theme decides what it looks like.
enum class ChartInk { accent, survey, warning, secondary, grew, shrank, within_error };
struct ChartColour {
  ChartInk ink = ChartInk::accent;
  std::size_t survey = 0;  ///< order by date, for ChartInk::survey
  bool operator==(const ChartColour&) const = default;
};

struct ChartAxis {
  std::string title;  ///< "DBH"
  std::string unit;   ///< "cm"; "" for a count
  double low = 0.0;
  double high = 1.0;
  std::vector<double> ticks;             ///< empty: the painter chooses
  std::vector<std::string> tick_labels;  ///< empty: the numbers
  std::string note = {};  ///< after the title: "end bars count all beyond"
  bool operator==(const ChartAxis&) const = default;
};

struct ChartBar {
  double x_low = 0.0, x_high = 0.0;  ///< edges of the bar
  double value = 0.0;
  std::vector<TreeId> trees;         ///< what it counts, for selecting by a click
  std::string label;                 ///< the class it counts: "5.0 to 10.0 cm"; the outermost may be open: "below 5.0 cm"
  bool operator==(const ChartBar&) const = default;
};
struct ChartBars {
  std::string name;
  ChartColour colour;
  std::vector<ChartBar> bars;
  bool operator==(const ChartBars&) const = default;
};

struct ChartPoint {
  double x = 0.0, y = 0.0;
  double y_error = 0.0;  ///< half the length of the error bar, 0: none
  TreeId tree;
  bool operator==(const ChartPoint&) const = default;
};
struct ChartPoints {
  std::string name;
  ChartColour colour;
  std::vector<ChartPoint> points;
  bool is_joined = false;  ///< a line with open circles; else a cloud of dots
  bool has_marks = true;   ///< of a joined one: the circles
  bool operator==(const ChartPoints&) const = default;
};

/// A softly filled stretch of an axis, such as the 20-80 % band.
struct ChartBand {
  double low = 0.0, high = 0.0;
  bool is_on_x = true;
  std::string label;
  ChartColour colour;
  bool operator==(const ChartBand&) const = default;
};
/// A thin line across the chart at one value.
struct ChartRule {
  double at = 0.0;
  bool is_on_x = true;
  std::string label;
  bool is_strong = false;
  bool operator==(const ChartRule&) const = default;
};

/// A box from the lower to the upper quartile with its median, and whiskers.
struct ChartBox {
  double x = 0.0;      ///< its middle
  double width = 0.6;  ///< in units of x
  double whisker_low = 0.0, low = 0.0, median = 0.0, high = 0.0, whisker_high = 0.0;
  ChartColour colour;
  bool operator==(const ChartBox&) const = default;
};

/// One sector of a rose about the origin; angles clockwise from the +y axis.
struct ChartPetal {
  double from_rad = 0.0, to_rad = 0.0;
  double radius = 0.0;         ///< in units of the axes
  std::string label;           ///< "towards 0 to 22°: 34 stems"
  std::vector<TreeId> trees;
  bool operator==(const ChartPetal&) const = default;
};

struct ChartModel {
  std::string title;
  std::string note;  ///< one line below the title: "3544 stems, median 0.9 cm (0.7 to 1.1)"
  ChartAxis x, y;
  std::vector<ChartBand> bands;
  std::vector<ChartRule> rules;
  std::vector<ChartBars> bars;
  std::vector<ChartPoints> points;
  std::vector<ChartBox> boxes;
  std::vector<ChartPetal> petals;  ///< not empty: a rose in a square, rings instead of axes
  std::string empty_text;  ///< why there is nothing to see, and what to do; empty when there is
  bool operator==(const ChartModel&) const = default;
};

/// Stems per DBH class and survey.
ChartModel dbh_class_chart(const ProjectState& state, const Tables& tables, double class_width_m = 0.05);
/// DBH change between two surveys, with its 20-80 % band, median and the measurement error.
ChartModel growth_distribution_chart(const ProjectState& state, const Tables& tables, InventoryId from, InventoryId to);
/// DBH change against the earlier DBH, a dot per tree.
ChartModel growth_against_dbh_chart(const ProjectState& state, const Tables& tables, InventoryId from, InventoryId to);
/// One tree's measured diameters with their error, by date (by survey where dates are missing).
ChartModel dbh_over_time_chart(const ProjectState& state, const Tables& tables, TreeId tree);
/// Distances between the matched stems of two surveys.
ChartModel residual_chart(const ProjectState& state, const Tables& tables, InventoryId from, InventoryId to);
/// Into which direction the later of two matched stems lies from the earlier one: a rose that is not round shows a shift that
/// is left in the alignment.
ChartModel residual_rose_chart(const ProjectState& state, const Tables& tables, InventoryId from, InventoryId to);
/// Every chart of a project that belongs into a report, in order: classes, then growth and residuals per pair of
/// consecutive surveys.
std::vector<ChartModel> report_charts(const ProjectState& state, const Tables& tables);

/// How a report gets its figures without knowing who paints: `app` fills it from `render`.
class ChartPictures {
 public:
  virtual ~ChartPictures() = default;
  virtual std::string svg(const ChartModel& chart, int width_px, int height_px) const = 0;
  virtual std::vector<std::uint8_t> png(const ChartModel& chart, int width_px, int height_px, double scale) const = 0;
};

}  // namespace stemwise
