/// One benchmark per stage of localising, one thread, and one for the whole query. CPU time is what counts.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include "benchmarks/sequences.hpp"
#include <benchmark/benchmark.h>

#include "core/treeloc/localizer.hpp"
#include "core/treeloc/match_trees.hpp"
#include "core/treeloc/prepare_scene.hpp"
#include "core/treeloc/refine_pose.hpp"
#include "core/treeloc/triangle_index.hpp"
#include "core/treeloc/vote_scenes.hpp"
#include "io/read_frame_folder.hpp"
#include "io/survey_reader.hpp"

namespace stemwise::benchmarks {
namespace {

using namespace treeloc;

/// Everything that several stages need, made once.
struct Bench {
  explicit Bench(Sequences given)
      : sequences(std::move(given)), settings(settings_for(Method::stemwise, "auto")), index(settings.triangles) {
    queries = prepare_frame_scenes(sequences.query, settings.scene, settings.axes, 1);
    map = prepare_frame_scenes(sequences.map, settings.scene, settings.axes, 1);
    index.add(map, 1);
    for (const Scene& scene : map) map_trees.add(scene);
    for (const Scene& scene : queries) query_trees.add(scene);
  }
  Sequences sequences;
  Settings settings;
  std::vector<Scene> queries, map;
  TriangleIndex index;
  PlanarTreeStore map_trees, query_trees;
};

void per_item(benchmark::State& state, std::size_t items) {
  state.counters["per_item"] =
      benchmark::Counter(static_cast<double>(items), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void read(benchmark::State& state, const Bench& bench) {
  for (auto _ : state) benchmark::DoNotOptimize(read_frame_folder(bench.sequences.query_folder, 1));
  per_item(state, bench.sequences.query.frames.size());
}

/// Files to scenes and triangles, as `evaluate` does it.
void survey(benchmark::State& state, const Bench& bench) {
  const SurveyReader reader({}, 1);
  for (auto _ : state) benchmark::DoNotOptimize(reader.read(bench.sequences.query_folder, bench.settings, true));
  per_item(state, bench.sequences.query.frames.size());
}

/// The same from the descriptor cache.
void cached_survey(benchmark::State& state, const Bench& bench) {
  const auto folder = std::filesystem::temp_directory_path() / "stemwise_benchmark_cache";
  const SurveyReader reader({folder.string(), DescriptorCache::usual_most_bytes, "benchmark", {}}, 1);
  bool is_kept = reader.read(bench.sequences.query_folder, bench.settings, true).value.has_value();
  for (auto _ : state) {
    const auto read = reader.read(bench.sequences.query_folder, bench.settings, true);
    is_kept = is_kept && read->scenes_from_cache && read->triangles_from_cache;
  }
  if (!is_kept) state.SkipWithError("nothing came from the cache");
  per_item(state, bench.sequences.query.frames.size());
  std::filesystem::remove_all(folder);
}

void prepare(benchmark::State& state, const Bench& bench) {
  for (auto _ : state)
    benchmark::DoNotOptimize(prepare_frame_scenes(bench.sequences.query, bench.settings.scene, bench.settings.axes, 1));
  per_item(state, bench.queries.size());
}

void describe(benchmark::State& state, const Bench& bench) {
  TriangleMaker maker(bench.settings.triangles);
  for (auto _ : state) {
    for (const Scene& scene : bench.queries) benchmark::DoNotOptimize(maker.make(scene).data());
  }
  per_item(state, bench.queries.size());
}

void index_build(benchmark::State& state, const Bench& bench) {
  for (auto _ : state) {
    TriangleIndex index(bench.settings.triangles);
    index.add(bench.map, 1);
    benchmark::DoNotOptimize(index.triangle_count());
  }
  per_item(state, bench.map.size());
}

constexpr std::size_t every = 4;  // of the queries

void retrieve(benchmark::State& state, const Bench& bench) {
  std::vector<std::vector<Triangle>> triangles;
  TriangleMaker maker(bench.settings.triangles);
  for (std::size_t q = 0; q < bench.queries.size(); q += every) triangles.push_back(maker.make(bench.queries[q]));
  SceneVote vote(bench.settings.vote);
  for (auto _ : state) {
    for (const auto& t : triangles) benchmark::DoNotOptimize(vote.vote(bench.index, t, QueryWorker::all_scenes).size());
  }
  per_item(state, triangles.size());
}

/// What retrieval proposes for every fourth query.
struct Proposals {
  std::size_t query = 0;
  std::vector<VotedScene> scenes;
};

std::vector<Proposals> proposals(const Bench& bench) {
  std::vector<Proposals> all;
  TriangleMaker maker(bench.settings.triangles);
  SceneVote vote(bench.settings.vote);
  for (std::size_t q = 0; q < bench.queries.size(); q += every) {
    const auto voted = vote.vote(bench.index, maker.make(bench.queries[q]), QueryWorker::all_scenes);
    all.push_back({q, {voted.begin(), voted.end()}});
  }
  return all;
}

void verify(benchmark::State& state, const Bench& bench) {
  const auto all = proposals(bench);
  TreeMatcher matcher(bench.settings.match);
  for (auto _ : state) {
    for (const Proposals& p : all) {
      for (const VotedScene& v : p.scenes)
        benchmark::DoNotOptimize(matcher.match(bench.query_trees.trees(p.query), bench.map_trees.trees(v.scene), v.pose));
    }
  }
  per_item(state, all.size());
}

void pose(benchmark::State& state, const Bench& bench) {
  const auto all = proposals(bench);
  TreeMatcher matcher(bench.settings.match);
  for (auto _ : state) {
    for (const Proposals& p : all) {
      if (p.scenes.empty()) continue;
      const VotedScene& v = p.scenes.front();
      matcher.pair(bench.query_trees.trees(p.query), bench.map_trees.trees(v.scene), v.pose, bench.settings.match.fine_m);
      benchmark::DoNotOptimize(
          refine_pose(bench.queries[p.query], bench.map[v.scene], matcher.pairs(), v.pose, bench.settings.refine));
    }
  }
  per_item(state, all.size());
}

/// Retrieval to pose, as `evaluate` measures it; the describing of the query is in it too.
void query(benchmark::State& state, const Bench& bench, const Localizer& localizer) {
  const auto worker = localizer.worker();
  double retrieve_s = 0.0, verify_s = 0.0, describe_s = 0.0, count = 0.0;
  for (auto _ : state) {
    for (std::size_t q = 0; q < bench.queries.size(); q += every) {
      const Localization found = worker->localize(bench.queries[q], QueryWorker::all_scenes);
      retrieve_s += found.retrieve_s, verify_s += found.verify_s, describe_s += found.describe_s, count += 1.0;
    }
  }
  per_item(state, (bench.queries.size() + every - 1) / every);
  state.counters["describe_ms"] = 1e3 * describe_s / count;
  state.counters["retrieve_ms"] = 1e3 * retrieve_s / count;
  state.counters["verify_ms"] = 1e3 * verify_s / count;
}

/// Folders to poses: what `evaluate inter` does, without its statistics.
void macro(benchmark::State& state, const Bench& bench) {
  for (auto _ : state) {
    const auto localizer = make_localizer(bench.settings);
    const auto map = read_frame_folder(bench.sequences.map_folder, 1);
    localizer->add(prepare_frame_scenes(*map->frames, bench.settings.scene, bench.settings.axes, 1), 1);
    const auto read = read_frame_folder(bench.sequences.query_folder, 1);
    const auto scenes = prepare_frame_scenes(*read->frames, bench.settings.scene, bench.settings.axes, 1);
    benchmark::DoNotOptimize(localize_all(*localizer, scenes, {}, 1, {}));
  }
}

}  // namespace

void add_stages() {
  const auto bench = std::make_shared<const Bench>(load_sequences());
  const std::shared_ptr<Localizer> localizer = make_localizer(bench->settings);
  localizer->add(bench->map, 1);
  const auto add = [&](const char* name, auto stage) {
    benchmark::RegisterBenchmark(name, [bench, stage](benchmark::State& state) {
      stage(state, *bench);
    })->Unit(benchmark::kMillisecond);
  };
  if (!bench->sequences.query_folder.empty()) {
    add("read", read);
    add("survey", survey);
    add("cached_survey", cached_survey);
  }
  add("prepare", prepare);
  add("describe", describe);
  add("index_build", index_build);
  add("retrieve", retrieve);
  add("verify", verify);
  add("pose", pose);
  benchmark::RegisterBenchmark("query", [bench, localizer](benchmark::State& state) {
    query(state, *bench, *localizer);
  })->Unit(benchmark::kMillisecond);
  if (!bench->sequences.query_folder.empty()) add("macro", macro);
}

}  // namespace stemwise::benchmarks
