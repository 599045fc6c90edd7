/// How the time of a query grows with the database: 1,000 to 100,000 synthetic scenes of one walk, the same queries.
#include <memory>
#include <vector>

#include "benchmarks/sequences.hpp"
#include <benchmark/benchmark.h>

#include "core/treeloc/localizer.hpp"
#include "core/treeloc/prepare_scene.hpp"

namespace stemwise::benchmarks {
namespace {

using namespace treeloc;

constexpr std::size_t most_scenes = 100'000;
constexpr std::size_t query_count = 200;

struct Scaling {
  Settings settings = settings_for(Method::stemwise, "auto");
  std::vector<Scene> scenes, queries;

  void make() {
    if (!scenes.empty()) return;
    const FrameSet frames = synthetic_frames(most_scenes, 1, most_scenes);
    scenes = prepare_frame_scenes(frames, settings.scene, settings.axes, 0);
    queries = prepare_frame_scenes(synthetic_frames(most_scenes, 2, query_count), settings.scene, settings.axes, 0);
  }
};

void query_among(benchmark::State& state, Scaling& data) {
  data.make();
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto localizer = make_localizer(data.settings);
  localizer->add(std::vector<Scene>{data.scenes.begin(), data.scenes.begin() + static_cast<std::ptrdiff_t>(count)}, 0);
  const auto worker = localizer->worker();
  double retrieve_s = 0.0, verify_s = 0.0, done = 0.0, right = 0.0;
  for (auto _ : state) {
    for (const Scene& query : data.queries) {
      const Localization found = worker->localize(query, QueryWorker::all_scenes);
      retrieve_s += found.retrieve_s, verify_s += found.verify_s, done += 1.0;
      if (found.candidates.empty()) continue;
      const Scene& scene = localizer->scenes()[found.candidates.front().scene];
      right += (scene.survey_from_scene.translation_m - query.survey_from_scene.translation_m).head<2>().norm() < 5.0 ? 1.0 : 0.0;
    }
  }
  state.counters["retrieve_ms"] = 1e3 * retrieve_s / done;
  state.counters["verify_ms"] = 1e3 * verify_s / done;
  state.counters["recall_at_1"] = right / done;
  state.counters["per_query"] = benchmark::Counter(static_cast<double>(query_count),
                                                   benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

void add_scaling() {
  const auto data = std::make_shared<Scaling>();
  auto* registered = benchmark::RegisterBenchmark("query_among", [data](benchmark::State& state) { query_among(state, *data); });
  for (const int scenes : {1'000, 3'000, 10'000, 30'000, 100'000}) registered->Arg(scenes);
  registered->Unit(benchmark::kMillisecond);
}

}  // namespace stemwise::benchmarks
