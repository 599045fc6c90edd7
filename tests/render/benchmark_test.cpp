#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "demo_forest.hpp"
#include "render/surfaceless_context.hpp"
#include "render/viewport.hpp"

// Prints the frame rates of issue 4 and the renderer's name; asserts nothing about time. Run with STEMWISE_BENCHMARK=1.
namespace stemwise::render {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void measure(Viewport& viewport, const test::DemoForest& forest, ViewKind kind) {
  constexpr PixelSize size{970, 575};
  ViewOptions options;
  options.kind = kind;
  options.moving = true;
  viewport.set_options(options);
  const auto synced = Clock::now();
  viewport.sync(forest.state(), forest.tables(), 1);
  const double sync_s = seconds_since(synced);
  viewport.render(size, 1.0);
  viewport.fit();
  int frames = 0;
  const auto start = Clock::now();
  const std::clock_t cpu = std::clock();
  while (seconds_since(start) < 2.0) {
    kind == ViewKind::map ? viewport.pan(frames % 2 ? 6.0 : -6.0, 2.0) : viewport.orbit(4.0, 0.0);
    viewport.render(size, 1.0);
    (void)viewport.image();  // waits until it is really drawn
    ++frames;
  }
  const double moving_fps = frames / seconds_since(start);
  const double cpu_ms = 1000.0 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / frames;
  options.moving = false;
  viewport.set_options(options);
  const auto rest = Clock::now();
  viewport.render(size, 1.0);
  (void)viewport.image();
  const double rest_s = seconds_since(rest);
  const auto picking = Clock::now();
  for (int i = 0; i < 20; ++i) (void)viewport.pick(40.0 * i, 25.0 * i);
  std::printf("%-5s %7d stems  moving %6.1f frames/s (%5.1f ms of processor each)  at rest %6.0f ms  pick %5.2f ms  sync %5.0f ms\n", kind == ViewKind::map ? "map" : "3D",
              static_cast<int>(forest.tables().observations.size()), moving_fps, cpu_ms, 1000.0 * rest_s, 50.0 * seconds_since(picking), 1000.0 * sync_s);
}

TEST(Benchmark, FrameRatesOfTheViewport) {
  if (!std::getenv("STEMWISE_BENCHMARK")) GTEST_SKIP() << "SKIPPED: set STEMWISE_BENCHMARK=1 to measure";
  auto context = SurfacelessContext::create();
  if (!context) GTEST_SKIP() << "SKIPPED: no EGL surfaceless context";
  std::printf("renderer: %s, viewport 970 x 575\n", (*context)->renderer_name().c_str());
  for (const int stems : {5'000, 50'000, 100'000}) {
    const test::DemoForest forest(stems * 10 / 29);
    for (const ViewKind kind : {ViewKind::map, ViewKind::space}) {
      Viewport viewport;
      measure(viewport, forest, kind);
    }
  }
}

}  // namespace
}  // namespace stemwise::render
