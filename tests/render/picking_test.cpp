#include <gtest/gtest.h>

#include "demo_forest.hpp"
#include "render/viewport.hpp"

namespace stemwise::render {
namespace {

using test::DemoForest;

constexpr PixelSize size{970, 575};

Viewport made(const DemoForest& forest, ViewKind kind) {
  Viewport viewport;
  ViewOptions options;
  options.kind = kind;
  viewport.resize(size, 1.0);
  viewport.set_options(options);
  viewport.sync(forest.state(), forest.tables(), 1);
  return viewport;
}

TEST(Picking, OnTheMapAClickOnATreeFindsIt) {
  const DemoForest forest(400);
  const Viewport viewport = made(forest, ViewKind::map);
  int shown = 0, found = 0;
  for (const TreeRow& tree : forest.tables().trees) {
    const auto pixel = viewport.pixels_of(tree.tree);
    if (!pixel) continue;
    ++shown;
    const auto pick = viewport.pick(pixel->x(), pixel->y());
    ASSERT_TRUE(pick);
    found += pick->tree == tree.tree;
  }
  EXPECT_GT(shown, 390);
  EXPECT_GT(found, shown * 97 / 100);  // two stems of one spot may cover each other
}

TEST(Picking, InSpaceAClickOnAStemFindsItOrOneInFront) {
  const DemoForest forest(100);
  Viewport viewport = made(forest, ViewKind::space);
  int shown = 0, found = 0;
  for (const TreeRow& tree : forest.tables().trees) {
    viewport.fly_to(tree.tree, false);
    const auto pixel = viewport.pixels_of(tree.tree);
    ASSERT_TRUE(pixel);
    ++shown;
    const auto pick = viewport.pick(pixel->x(), pixel->y());
    ASSERT_TRUE(pick);
    found += pick->tree == tree.tree;
  }
  EXPECT_GT(found, shown * 7 / 10);
}

TEST(Picking, EmptyGroundIsNoTree) {
  const DemoForest forest(100);
  const Viewport viewport = made(forest, ViewKind::map);
  EXPECT_FALSE(viewport.pick(1.0, 1.0, 2.0));
}

TEST(Picking, ARectangleOverEverythingHoldsEveryTree) {
  const DemoForest forest(200);
  const Viewport viewport = made(forest, ViewKind::map);
  EXPECT_EQ(viewport.trees_in_rectangle(0, 0, size.width, size.height).size(), forest.tables().trees.size());
  EXPECT_TRUE(viewport.trees_in_rectangle(0, 0, 3, 3).empty());
}

TEST(Picking, ALassoHoldsWhatLiesInside) {
  const DemoForest forest(200);
  const Viewport viewport = made(forest, ViewKind::map);
  const std::vector<Eigen::Vector2d> left_half{{0, 0}, {0, size.height}, {size.width / 2, size.height}, {size.width / 2, 0}};
  EXPECT_EQ(viewport.trees_in_polygon(left_half), viewport.trees_in_rectangle(0, 0, size.width / 2, size.height));
  EXPECT_TRUE(viewport.trees_in_polygon({}).empty());
}

TEST(Picking, HidingASurveyHidesTheTreesThatOnlyItSaw) {
  const DemoForest forest(300);
  Viewport viewport = made(forest, ViewKind::map);
  const int all = viewport.shown_marks();
  ViewOptions options = viewport.options();
  options.hidden = {forest.state().inventories[0]->id, forest.state().inventories[1]->id};
  viewport.set_options(options);
  viewport.sync(forest.state(), forest.tables(), 1);
  EXPECT_EQ(static_cast<std::size_t>(viewport.shown_marks()), forest.state().inventories[2]->stems.size());
  EXPECT_LT(viewport.shown_marks(), all);
}

TEST(Camera, ZoomingKeepsThePlaceUnderTheCursor) {
  const DemoForest forest(100);
  Viewport viewport = made(forest, ViewKind::map);
  const auto before = viewport.world_at(700.0, 120.0);
  viewport.zoom_at(700.0, 120.0, 3.7);
  const auto after = viewport.world_at(700.0, 120.0);
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(before->position_m.x(), after->position_m.x(), 1e-9);
  EXPECT_NEAR(before->position_m.y(), after->position_m.y(), 1e-9);
}

TEST(Camera, PixelsAndWorldAreEachOthersInverse) {
  const DemoForest forest(100);
  for (const ViewKind kind : {ViewKind::map, ViewKind::space}) {
    const Viewport viewport = made(forest, kind);
    const auto world = viewport.world_at(420.0, 330.0);
    ASSERT_TRUE(world);
    const Eigen::Vector2d pixel = viewport.pixels_of(world->position_m);
    EXPECT_NEAR(pixel.x(), 420.0, 0.5);
    EXPECT_NEAR(pixel.y(), 330.0, 0.5);
  }
}

TEST(Camera, AFlightEndsAtTheTree) {
  const DemoForest forest(400);
  Viewport viewport = made(forest, ViewKind::map);
  const TreeId tree = forest.tables().trees[17].tree;
  viewport.fly_to(tree, true);
  EXPECT_TRUE(viewport.advance(0.05));
  EXPECT_FALSE(viewport.advance(0.10));
  const auto pixel = viewport.pixels_of(tree);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 0.5 * size.width, 1e-6);
  EXPECT_NEAR(pixel->y(), 0.5 * size.height, 1e-6);
}

TEST(Camera, AnotherSizeFitsAgainUnlessAPersonMovedTheView) {
  const DemoForest forest(100);
  const PixelSize other{600, 420};
  Viewport fitted = made(forest, ViewKind::map), moved = made(forest, ViewKind::map), fresh;
  const double before = fitted.metres_per_px();
  fitted.resize(other, 1.0);
  fresh.resize(other, 1.0);
  fresh.set_options(fitted.options());
  fresh.sync(forest.state(), forest.tables(), 1);
  EXPECT_DOUBLE_EQ(fitted.metres_per_px(), fresh.metres_per_px());
  EXPECT_NE(fitted.metres_per_px(), before);
  moved.zoom_at(300.0, 200.0, 2.0);
  const double chosen = moved.metres_per_px();
  moved.resize(other, 1.0);
  EXPECT_DOUBLE_EQ(moved.metres_per_px(), chosen);
}

TEST(Camera, UtmSizedCoordinatesLoseNothing) {
  ProjectState state;
  Inventory inventory;
  inventory.name = "utm";
  for (int i = 0; i < 50; ++i) {
    Stem stem;
    stem.x_m = 512'214.438 + 3.1 * (i % 7);
    stem.y_m = 5'402'096.021 + 2.7 * (i / 7);
    stem.dbh_m = 0.3;
    inventory.stems.push_back(stem);
  }
  Project project;
  project.execute(add_inventory(inventory));
  const Tables tables = derive_tables(project.state());
  Viewport viewport;
  viewport.resize(size, 1.0);
  viewport.sync(project.state(), tables, 1);
  const StemRef stem{project.state().reference, 11};
  const auto pixel = viewport.pixels_of(stem);
  ASSERT_TRUE(pixel);
  const auto world = viewport.world_at(pixel->x(), pixel->y());
  ASSERT_TRUE(world);
  EXPECT_NEAR(world->position_m.x(), inventory.stems[11].x_m, 1e-6);
  EXPECT_NEAR(world->position_m.y(), inventory.stems[11].y_m, 1e-6);
}

}  // namespace
}  // namespace stemwise::render
