#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.hpp"
#include "core/underlay/arrange_cloud.hpp"
#include "core/underlay/raster_underlay.hpp"
#include "demo_forest.hpp"
#include "golden.hpp"
#include "render/surfaceless_context.hpp"
#include "render/viewport.hpp"

namespace stemwise::render {
namespace {

constexpr PixelSize size{480, 320};

/// Red in the west, blue in the east, with a hole in the middle.
std::shared_ptr<const RasterUnderlay> two_colours(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m) {
  auto raster = std::make_shared<RasterUnderlay>(RasterUnderlay{.width_px = 64, .height_px = 32, .columns = 2, .rows = 2, .pixel_m = 1.0});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      const bool is_hole = std::abs(x - 32) < 6 && std::abs(y - 16) < 6;
      for (const int c : {x < 32 ? 220 : 20, 30, x < 32 ? 20 : 220, is_hole ? 0 : 255}) raster->rgba.push_back(static_cast<std::uint8_t>(c));
    }
  raster->nodes_in_reference_m = {{low_m.x(), high_m.y()}, high_m, low_m, {high_m.x(), low_m.y()}};
  return raster;
}

/// Ground and a canopy layer 15 m above it, in the stems' frame but with heights of another datum.
std::shared_ptr<const CloudUnderlay> two_storeys(const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m, int count = 60'000) {
  std::vector<RawPoint> points;
  Random random(2);
  for (int i = 0; i < count; ++i) {
    RawPoint p;
    p.position = {random.uniform(low_m.x(), high_m.x()), random.uniform(low_m.y(), high_m.y()), i % 2 ? 15.0 : 0.0};
    p.position.z() += 300.0 + random.normal(0.0, 0.05);
    p.intensity = static_cast<std::uint16_t>(i % 1000);
    points.push_back(p);
  }
  return std::make_shared<const CloudUnderlay>(arrange_cloud(std::move(points), 0.2));
}

class Underlays : public ::testing::Test {
 protected:
  Underlays() : forest_(320) {
    for (const ObservationRow& row : forest_.tables().observations) {
      low_m_ = low_m_.cwiseMin(row.position_m.head<2>());
      high_m_ = high_m_.cwiseMax(row.position_m.head<2>());
    }
    auto made = SurfacelessContext::create();
    if (made) context_ = std::move(*made);
  }
  void SetUp() override {
    if (!context_) GTEST_SKIP() << "SKIPPED: no EGL surfaceless context on this machine";
    viewport_ = std::make_unique<Viewport>();
  }
  void TearDown() override { viewport_.reset(); }

  Image draw(ViewOptions options) {
    viewport_->set_options(options);
    viewport_->sync(forest_.state(), forest_.tables(), 1);
    viewport_->render(size, 1.0);
    return viewport_->image();
  }
  /// Drawn, compared with the picture of this name, and kept for people who want to look.
  Image golden(const ViewOptions& options, const std::string& name) {
    Image image = draw(options);
    test::show(image, name);
    test::expect_golden(image, name);
    return image;
  }
  /// Mean colour around a place of the map.
  static Eigen::Vector3d colour_at(const Image& image, double share_x, double share_y) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    for (int dy = -12; dy <= 12; ++dy)
      for (int dx = -12; dx <= 12; ++dx, ++count) {
        const std::size_t i = 4 * (static_cast<std::size_t>(share_y * size.height + dy) * size.width + static_cast<std::size_t>(share_x * size.width + dx));
        sum += Eigen::Vector3d(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]);
      }
    return sum / count;
  }
  static ViewOptions options(ViewKind kind) { return {.kind = kind, .hidden = {}, .legend = false, .title = {}, .selected = {}, .selected_stems = {}, .hovered = {}, .ghost = {}, .underlays = {}}; }

  test::DemoForest forest_;
  Eigen::Vector2d low_m_ = Eigen::Vector2d::Constant(1e9), high_m_ = -low_m_;
  std::unique_ptr<SurfacelessContext> context_;
  std::unique_ptr<Viewport> viewport_;
};

TEST_F(Underlays, APictureLiesUnderTheStemsOfTheMapAsStrongAsItsOpacity) {
  ViewOptions o = options(ViewKind::map);
  const Image without = draw(o);
  o.underlays = {{.raster = two_colours(low_m_, high_m_)}};
  const Image full = golden(o, "map_underlay");
  EXPECT_GT(colour_at(full, 0.25, 0.6).x(), colour_at(full, 0.25, 0.6).z() + 100.0);
  EXPECT_GT(colour_at(full, 0.75, 0.6).z(), colour_at(full, 0.75, 0.6).x() + 100.0);
  o.underlays[0].opacity = 0.3;
  const Image faint = draw(o);
  const double before = colour_at(without, 0.25, 0.6).z(), between = colour_at(faint, 0.25, 0.6).z(), after = colour_at(full, 0.25, 0.6).z();
  EXPECT_NEAR(between, before + 0.3 * (after - before), 12.0);
  o.underlays.clear();
  EXPECT_LT(test::difference(draw(o), without), 0.001);  // and away again
}

TEST_F(Underlays, APictureLiesOnTheGroundIn3D) {
  ViewOptions o = options(ViewKind::space);
  const Image without = draw(o);
  o.underlays = {{.raster = two_colours(low_m_, high_m_)}};
  const Image with = golden(o, "space_underlay");
  EXPECT_GT(test::difference(with, without), 0.07);
}

TEST_F(Underlays, ACloudStandsOnTheStemsGroundAndItsHeightsAreClipped) {
  ViewOptions o = options(ViewKind::space);
  const Image without = draw(o);
  o.underlays = {{.cloud = two_storeys(low_m_, high_m_)}};
  const Image with = golden(o, "space_cloud");
  EXPECT_GT(test::difference(with, without), 0.12);  // 50 m higher it would be out of sight
  o.underlays[0].high_m = 5.0;
  const Image low = draw(o);
  EXPECT_GT(test::difference(low, with), 0.08);
  o.underlays[0].low_m = 100.0;
  o.underlays[0].high_m = 200.0;
  EXPECT_LT(test::difference(draw(o), without), 0.001);
}

TEST_F(Underlays, ACloudIsDrawnOnTheMapByHeightOrIntensity) {
  ViewOptions o = options(ViewKind::map);
  const Image without = draw(o);
  o.underlays = {{.cloud = two_storeys(low_m_, high_m_)}};
  const Image by_height = golden(o, "map_cloud");
  EXPECT_GT(test::difference(by_height, without), 0.18);
  o.underlays[0].shade = CloudShade::intensity;
  EXPECT_GT(test::difference(draw(o), by_height), 0.05);
}

TEST_F(Underlays, AMovingViewDrawsFewerPointsAndRestShowsAllAgain) {
  ViewOptions o = options(ViewKind::space);
  o.underlays = {{.cloud = two_storeys(low_m_, high_m_, 400'000)}};
  const Image rest = draw(o);
  o.moving = true;
  EXPECT_GT(test::difference(draw(o), rest), 0.02);
  o.moving = false;
  EXPECT_LT(test::difference(draw(o), rest), 0.001);
}

}  // namespace
}  // namespace stemwise::render
