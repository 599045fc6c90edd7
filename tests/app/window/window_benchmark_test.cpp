#include <GL/gl.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "app/window/requests.hpp"
#include "core/base/random.hpp"
#include "core/underlay/arrange_cloud.hpp"
#include "core/underlay/raster_underlay.hpp"
#include "io/underlay/read_cloud_underlay.hpp"
#include "tests/app/window/window_fixture.hpp"
#include "tests/render/demo_forest.hpp"

// Prints the figures of the review desk's acceptance for the whole window (1600 x 1000, its viewport about 970 x 575) and
// names the renderer; asserts nothing about time. Run with STEMWISE_BENCHMARK=1. Frames per second are by the clock and
// by the processor's time of all threads: on a machine that does other things only the latter means something.
namespace stemwise {
namespace {

using Clock = std::chrono::steady_clock;

class WindowBenchmark : public WindowTest {
 protected:
  static double ms_since(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

  void finish_frame() {
    window().frame();
    glFinish();
  }

  struct Rate {
    double frames_per_s, cpu_ms;
  };
  /// Drags with the left button for two seconds.
  Rate moving(ui::ViewMode mode) {
    model().view.mode = mode;
    model().viewport.fit();
    window().settle();
    const ui::Rect map = window().desk().registry().find("viewport")->rect;
    window().move_to(map.center_x(), map.center_y());
    hold(true);
    const auto start = Clock::now();
    const std::clock_t cpu = std::clock();
    int frames = 0;
    while (ms_since(start) < 2000.0) {
      move(map.center_x() + static_cast<float>((frames % 40) * 4 - 80), map.center_y() + static_cast<float>(frames % 7));
      finish_frame();
      ++frames;
    }
    const Rate rate{1000.0 * frames / ms_since(start), 1000.0 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / frames};
    hold(false);
    finish_frame();
    return rate;
  }
  static void move(float x, float y) { ImGui::GetIO().MousePos = {x, y}; }
  static void hold_quietly(bool down) { ImGui::GetIO().MouseDown[0] = down; }
  void hold(bool down) {
    hold_quietly(down);
    window().frame();
  }

  /// Processor time of the longest of the frames that a press on the head of a column takes.
  double sort_ms() {
    model().view.tab = ui::BottomTab::matches;
    window().settle();
    const ui::WidgetEntry* head = window().desk().registry().find("matches/head/Distance, m");
    if (head == nullptr) return -1.0;
    const ui::Rect rect = head->rect;
    window().move_to(rect.center_x(), rect.center_y());
    double longest = 0.0;
    for (const bool down : {true, false, false, false}) {
      hold_quietly(down);
      const std::clock_t cpu = std::clock();
      finish_frame();
      longest = std::max(longest, 1000.0 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC);
    }
    return longest;
  }

  static double thread_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
  }

  /// Processor time of the drawing thread for the longest frame until everything has settled after `act`, drawing included.
  template <class Act>
  double longest_frame_ms(const Act& act) {
    double longest = 0.0;
    bool is_first = true;
    for (int calm = 0; calm < 5;) {
      const double before = thread_ms();
      if (std::exchange(is_first, false)) act();
      window().frame();
      longest = std::max(longest, thread_ms() - before);
      if (model().jobs.is_busy()) model().jobs.wait_for_news();
      calm = model().jobs.is_busy() || !model().document.is_derived() ? 0 : calm + 1;
    }
    return longest;
  }

  double pick_ms() {
    const auto start = Clock::now();
    for (int i = 0; i < 20; ++i) (void)model().viewport.viewport().pick(40.0 * i, 25.0 * i);
    return ms_since(start) / 20.0;
  }

  /// Share of a core that an untouched window takes: one frame every so many seconds.
  double idle_percent() {
    window().settle();
    for (int i = 0; i < 5; ++i) finish_frame();
    const std::clock_t cpu = std::clock();
    for (int i = 0; i < 10; ++i) finish_frame();
    const double frame_s = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / 10.0;
    return 100.0 * frame_s / std::max(window().desk().seconds_to_next_frame(), 1e-3);
  }
};


TEST_F(WindowBenchmark, FrameRatesPickingSortingAndIdlenessOfTheWholeWindow) {
  if (!std::getenv("STEMWISE_BENCHMARK")) GTEST_SKIP() << "SKIPPED: set STEMWISE_BENCHMARK=1 to measure";
  for (const int stems : {5'000, 50'000, 100'000}) {
    const test::DemoForest forest(stems * 10 / 29);
    model().document.replace(forest.state(), "", {}, true);
    model().view.step = ui::Step::review;
    window().settle();
    const ui::Rect map = window().desk().registry().find("viewport")->rect;
    if (stems == 5'000) std::printf("renderer: %s, window 1600 x 1000, viewport %.0f x %.0f\n", model().status.renderer.c_str(), map.width, map.height);
    const Rate in_map = moving(ui::ViewMode::map), in_space = moving(ui::ViewMode::space);
    std::printf("%7d stems  map %5.1f frames/s (%4.0f ms CPU each)  3D %5.1f (%4.0f ms)  pick %5.2f ms  sort %4.0f ms CPU  idle %.2f %% of a core\n",
                static_cast<int>(forest.tables().observations.size()), in_map.frames_per_s, in_map.cpu_ms, in_space.frames_per_s, in_space.cpu_ms, pick_ms(), sort_ms(),
                idle_percent());
    const QueueRow doubt = model().document.derived().tables.queue.front();
    const double drawn_ms = longest_frame_ms([&] { model().viewport.fit(); });
    const double selected_ms = longest_frame_ms([&] { select_tree(model(), doubt.tree, false); });
    const double decided_ms = longest_frame_ms([&] { model().execute(set_tree_note(doubt.tree, "seen", stamp_now())); });
    const double undone_ms = longest_frame_ms([&] { model().document.undo(); });
    const double coloured_ms = longest_frame_ms([&] { model().view.color_by = model().view.color_by == ui::ColorBy::dbh ? ui::ColorBy::growth : ui::ColorBy::dbh; });
    const double merging_ms = longest_frame_ms([&] { model().view.step = ui::Step::merge; });
    const double reporting_ms = longest_frame_ms([&] { model().view.step = ui::Step::report; });
    const double charts_ms = longest_frame_ms([&] { model().view.tab = ui::BottomTab::growth; });
    const double rose_ms = longest_frame_ms([&] { model().view.chart = ui::Chart::residual_rose; });
    const double conflicts_ms = longest_frame_ms([&] { model().view.tab = ui::BottomTab::conflicts; });
    std::printf("        drawing thread, longest frame: step 4 %.0f ms, step 5 %.0f ms, charts %.0f ms, rose %.0f ms, conflicts %.0f ms\n", merging_ms, reporting_ms, charts_ms, rose_ms, conflicts_ms);
    model().view.step = ui::Step::review;
    ProjectState other = forest.state();
    const double opened_ms = longest_frame_ms([&] { take_up(model(), std::move(other), "", {}, true); });
    std::printf("        drawing thread, longest frame: drawing again %.0f ms, selecting %.0f ms, deciding %.0f ms, undoing %.0f ms, another colouring %.0f ms, opening %.0f ms\n", drawn_ms, selected_ms, decided_ms, undone_ms,
                coloured_ms, opened_ms);
    if (stems == 5'000) std::printf("        while an alignment of them runs and arrives: %.0f ms\n", longest_frame_ms([&] { run_alignment(model()); }));
    std::fflush(stdout);
  }
}

/// A picture of 2048 x 2048 pixels and a cloud of as many points as are kept over these trees.
std::pair<std::shared_ptr<const RasterUnderlay>, std::shared_ptr<const CloudUnderlay>> large_underlays(const Tables& tables) {
  Eigen::AlignedBox2d box;
  for (const ObservationRow& row : tables.observations) box.extend(row.position_m.head<2>());
  Random random(5);
  auto raster = std::make_shared<RasterUnderlay>(RasterUnderlay{.width_px = 2048, .height_px = 2048, .columns = 2, .rows = 2, .pixel_m = 0.1});
  raster->rgba.resize(4UL * 2048 * 2048, 255);
  for (std::size_t i = 0; i < raster->rgba.size(); i += 4) raster->rgba[i] = static_cast<std::uint8_t>(random.below(256));
  raster->nodes_in_reference_m = {{box.min().x(), box.max().y()}, box.max(), box.min(), {box.max().x(), box.min().y()}};
  std::vector<RawPoint> points(most_cloud_points);
  for (RawPoint& p : points) p.position = {random.uniform(box.min().x(), box.max().x()), random.uniform(box.min().y(), box.max().y()), random.uniform() < 0.5 ? 250.0 : random.uniform(250.0, 275.0)};
  return {raster, std::make_shared<const CloudUnderlay>(arrange_cloud(std::move(points), 0.05))};
}

TEST_F(WindowBenchmark, FrameRatesWithLargeUnderlays) {
  if (!std::getenv("STEMWISE_BENCHMARK")) GTEST_SKIP() << "SKIPPED: set STEMWISE_BENCHMARK=1 to measure";
  const test::DemoForest forest(5'000 * 10 / 29);
  model().document.replace(forest.state(), "", {}, true);
  window().settle();
  const auto [raster, cloud] = large_underlays(forest.tables());
  model().underlays.tended_revision = model().document.revision();
  for (const bool is_cloud : {false, true}) {
    model().view.underlays.clear();
    model().view.underlays.push_back({.id = 1, .is_cloud = is_cloud, .opacity = is_cloud ? 1.0f : 0.75f, .state = ui::Underlay::State::shown});
    const double shown_ms = longest_frame_ms([&, &r = raster, &c = cloud] {
      is_cloud ? model().underlays.take(1, c) : model().underlays.take(1, r);
    });
    const double clipped_ms = longest_frame_ms([&] { model().view.underlays[0].high_m = 2.0f; });
    model().view.underlays[0].high_m = ui::Underlay::highest_m;
    const Rate in_map = moving(ui::ViewMode::map), in_space = moving(ui::ViewMode::space);
    std::printf("%s  map %5.1f frames/s (%4.0f ms CPU each)  3D %5.1f (%4.0f ms)  drawing thread when it comes %.0f ms, at other heights %.0f ms\n", is_cloud ? "cloud  " : "picture", in_map.frames_per_s,
                in_map.cpu_ms, in_space.frames_per_s, in_space.cpu_ms, shown_ms, clipped_ms);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace stemwise
