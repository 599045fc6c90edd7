#include "render/viewport.hpp"

#include <gtest/gtest.h>

#include "demo_forest.hpp"
#include "golden.hpp"
#include "render/snapshot.hpp"
#include "render/surfaceless_context.hpp"

namespace stemwise::render {
namespace {

using test::DemoForest;

constexpr PixelSize small{480, 320};
constexpr PixelSize panel{970, 575};

/// A viewport on a context of its own, drawn once; `context` is empty where the platform has none.
struct Stage {
  std::unique_ptr<SurfacelessContext> context;
  std::unique_ptr<Viewport> viewport = std::make_unique<Viewport>();

  Stage(const DemoForest& forest, const ViewOptions& options, PixelSize size, double scale = 1.0) {
    auto made = SurfacelessContext::create();
    if (!made) return;
    context = std::move(*made);
    viewport->set_options(options);
    viewport->sync(forest.state(), forest.tables(), 1);
    viewport->render(size, scale);
  }
  ~Stage() { viewport.reset(); }
};

#define NEEDS_CONTEXT(stage) \
  if (!(stage).context) GTEST_SKIP() << "SKIPPED: no EGL surfaceless context on this machine"

TEST(Viewport, MapLooksAsAgreedInBothThemes) {
  const DemoForest forest(320);
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const std::string name = theme == Theme::light ? "map_fate_light" : "map_fate_dark";
    ViewOptions options{.theme = theme, .hidden = {}, .title = {}, .selected = {forest.tables().trees[150].tree}, .selected_stems = {}, .hovered = {}, .ghost = {}};
    {
      Stage stage(forest, options, panel);
      NEEDS_CONTEXT(stage);
      test::show(stage.viewport->image(), name);
    }
    Stage stage(forest, options, small);
    test::expect_golden(stage.viewport->image(), name);
  }
}

TEST(Viewport, SpaceLooksAsAgreedInBothThemes) {
  const DemoForest forest(320);
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const std::string name = theme == Theme::light ? "space_fate_light" : "space_fate_dark";
    ViewOptions options{.kind = ViewKind::space, .theme = theme, .hidden = {}, .title = {}, .selected = {forest.tables().trees[150].tree}, .selected_stems = {}, .hovered = {}, .ghost = {}};
    {
      Stage stage(forest, options, panel);
      NEEDS_CONTEXT(stage);
      test::show(stage.viewport->image(), name);
    }
    Stage stage(forest, options, small);
    test::expect_golden(stage.viewport->image(), name);
  }
}

TEST(Viewport, EveryColouringDraws) {
  const DemoForest forest(320);
  for (const ColorBy by : all_color_bys)
    for (const ViewKind kind : {ViewKind::map, ViewKind::space}) {
      ViewOptions options;
      options.kind = kind;
      options.color_by = by;
      Stage stage(forest, options, panel);
      NEEDS_CONTEXT(stage);
      test::show(stage.viewport->image(), std::string(kind == ViewKind::map ? "map_" : "space_") + to_string(by));
      EXPECT_FALSE(stage.viewport->legend().title.empty());
    }
}

TEST(Viewport, HeatMapsAndResidualArrowsDraw) {
  const DemoForest forest(900);
  for (const HeatMap heat : {HeatMap::density, HeatMap::times_seen, HeatMap::residual})
    for (const Theme theme : {Theme::light, Theme::dark}) {
      ViewOptions options;
      options.heat = heat;
      options.theme = theme;
      options.residuals = heat == HeatMap::residual;
      Stage stage(forest, options, panel);
      NEEDS_CONTEXT(stage);
      const render::Image with_heat = stage.viewport->image();  // before another stage draws
      test::show(with_heat, "map_heat_" + std::to_string(static_cast<int>(heat)) + (theme == Theme::light ? "_light" : "_dark"));
      ViewOptions plain = options;
      plain.heat = HeatMap::none;
      plain.residuals = false;
      Stage without(forest, plain, panel);
      EXPECT_GT(test::difference(with_heat, without.viewport->image()), 0.02);
    }
}

TEST(Viewport, UnalignedSurveysStandBesideEachOther) {
  const DemoForest forest(200, false);
  Stage stage(forest, {}, panel);
  NEEDS_CONTEXT(stage);
  test::show(stage.viewport->image(), "map_unaligned");
  const auto& second = forest.state().inventories[1];
  const auto pixel = stage.viewport->pixels_of(StemRef{second->id, 5});
  ASSERT_TRUE(pixel);
  const auto world = stage.viewport->world_at(pixel->x(), pixel->y());
  ASSERT_TRUE(world);
  EXPECT_EQ(world->inventory, second->id);
  EXPECT_NEAR(world->position_m.x(), second->stems[5].x_m, 1e-6);
  EXPECT_NEAR(world->position_m.y(), second->stems[5].y_m, 1e-6);
}

TEST(Viewport, DrawsOnlyWhenSomethingChanged) {
  const DemoForest forest(100);
  Stage stage(forest, {}, small);
  NEEDS_CONTEXT(stage);
  Viewport& viewport = *stage.viewport;
  EXPECT_FALSE(viewport.is_dirty());
  viewport.sync(forest.state(), forest.tables(), 1);
  viewport.set_options(viewport.options());
  EXPECT_FALSE(viewport.is_dirty());
  viewport.pan(3.0, 0.0);
  EXPECT_TRUE(viewport.is_dirty());
  viewport.render(small, 1.0);
  EXPECT_FALSE(viewport.is_dirty());
  ViewOptions options = viewport.options();
  options.hovered = forest.tables().trees[3].tree;
  viewport.set_options(options);
  EXPECT_TRUE(viewport.is_dirty());
}

TEST(Viewport, TheSamePictureTwiceIsTheSameBytes) {
  const DemoForest forest(150);
  const auto first = take_snapshot(forest.state(), forest.tables(), {}, {.size = small});
  if (!first) GTEST_SKIP() << "SKIPPED: " << to_string(first.issues.front());
  const auto second = take_snapshot(forest.state(), forest.tables(), {}, {.size = small});
  EXPECT_TRUE(png_bytes(*first) == png_bytes(*second));
}

TEST(Viewport, AnEmptyProjectIsAnEmptyPictureAndNoCrash) {
  const ProjectState state;
  const Tables tables;
  for (const ViewKind kind : {ViewKind::map, ViewKind::space}) {
    ViewOptions options;
    options.kind = kind;
    const auto image = take_snapshot(state, tables, options, {.size = small});
    if (!image) GTEST_SKIP() << "SKIPPED: " << to_string(image.issues.front());
    EXPECT_EQ(image->size, small);
  }
}

TEST(Snapshot, APictureCarriesTitleLegendScaleAndNorth) {
  const DemoForest forest(320);
  const auto image = take_snapshot(forest.state(), forest.tables(), {}, {.size = {1600, 1000}, .scale = 1.25});
  if (!image) GTEST_SKIP() << "SKIPPED: " << to_string(image.issues.front());
  test::show(*image, "snapshot");
  EXPECT_EQ(image->size, (PixelSize{1600, 1000}));
}

TEST(Snapshot, RefusesASizeThatCannotBeDrawn) {
  const DemoForest forest(10);
  EXPECT_FALSE(take_snapshot(forest.state(), forest.tables(), {}, {.size = {0, 100}}));
  EXPECT_FALSE(take_snapshot(forest.state(), forest.tables(), {}, {.size = {100, 100'000}}));
}

}  // namespace
}  // namespace stemwise::render
