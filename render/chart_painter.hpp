#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/survey/chart_models.hpp"
#include "render/palette.hpp"
#include "render/picture.hpp"

namespace stemwise::render {

struct ChartStyle {
  PixelSize size{640, 360};  ///< of the picture; for SVG in units of 1/96 inch
  double scale = 1.0;        ///< picture pixels per interface pixel
  Theme theme = Theme::light;
  bool has_title = true;
  bool is_transparent = false;  ///< over a panel of the window
  std::vector<TreeId> selected; ///< marked in clouds of points and bars
  bool operator==(const ChartStyle&) const = default;
};

/// Where the plot lies in the picture, and what its edges mean: for hover and selection.
struct ChartLayout {
  Eigen::Vector2d low_px = Eigen::Vector2d::Zero();   ///< top left of the plot area, picture pixels
  Eigen::Vector2d high_px = Eigen::Vector2d::Zero();  ///< bottom right
  Eigen::Vector2d low = Eigen::Vector2d::Zero();      ///< values at the left and bottom edge
  Eigen::Vector2d high = Eigen::Vector2d::Zero();     ///< values at the right and top edge
  bool contains(const Eigen::Vector2d& pixel) const;
  Eigen::Vector2d value_at(const Eigen::Vector2d& pixel) const;
  Eigen::Vector2d pixel_of(const Eigen::Vector2d& value) const;
};

struct ChartPicture {
  Image image;
  ChartLayout layout;
};

/// What lies under the cursor in a chart: the trees it stands for, and words for a tooltip.
struct ChartHit {
  std::vector<TreeId> trees;
  std::string text;  ///< "30–35 cm: 214 stems (2023)"
};

/// One painter for screen, PNG and SVG; the same model and style give the same bytes.
ChartPicture paint_chart(const ChartModel& chart, const ChartStyle& style);
std::string chart_svg(const ChartModel& chart, const ChartStyle& style);
Result<Done> write_chart(const ChartModel& chart, const ChartStyle& style, const std::string& path);  ///< .png or .svg by suffix
std::optional<ChartHit> hit_chart(const ChartModel& chart, const ChartLayout& layout, const Eigen::Vector2d& pixel, double tolerance_px);
/// The trees whose points or bars lie in a rectangle of the picture.
std::vector<TreeId> trees_in_chart(const ChartModel& chart, const ChartLayout& layout, const Eigen::Vector2d& a_px, const Eigen::Vector2d& b_px);

/// For reports: core's interface, painted here.
class PaintedChartPictures : public ChartPictures {
 public:
  std::string svg(const ChartModel& chart, int width_px, int height_px) const override;
  std::vector<std::uint8_t> png(const ChartModel& chart, int width_px, int height_px, double scale) const override;
};

}  // namespace stemwise::render
