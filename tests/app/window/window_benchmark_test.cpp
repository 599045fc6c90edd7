#include <GL/gl.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "app/window/requests.hpp"
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
    model().document.replace(forest.state(), "", true);
    model().view.step = ui::Step::review;
    window().settle();
    const ui::Rect map = window().desk().registry().find("viewport")->rect;
    if (stems == 5'000) std::printf("renderer: %s, window 1600 x 1000, viewport %.0f x %.0f\n", model().status.renderer.c_str(), map.width, map.height);
    const Rate in_map = moving(ui::ViewMode::map), in_space = moving(ui::ViewMode::space);
    std::printf("%7d stems  map %5.1f frames/s (%4.0f ms CPU each)  3D %5.1f (%4.0f ms)  pick %5.2f ms  sort %4.0f ms CPU  idle %.2f %% of a core\n",
                static_cast<int>(forest.tables().observations.size()), in_map.frames_per_s, in_map.cpu_ms, in_space.frames_per_s, in_space.cpu_ms, pick_ms(), sort_ms(),
                idle_percent());
    const QueueRow doubt = model().document.derived().tables.queue.front();
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
    const double opened_ms = longest_frame_ms([&] { model().document.replace(forest.state(), "", true); });
    std::printf("        drawing thread, longest frame: selecting %.0f ms, deciding %.0f ms, undoing %.0f ms, another colouring %.0f ms, opening %.0f ms\n", selected_ms, decided_ms, undone_ms,
                coloured_ms, opened_ms);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace stemwise
