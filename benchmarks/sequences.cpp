#include "benchmarks/sequences.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "core/simulate/simulate_forest.hpp"
#include "core/survey/simulate_frames.hpp"
#include "io/read_frame_folder.hpp"

namespace stemwise::benchmarks {
namespace {

/// The stand is as large as the walk needs: one frame per 2 m on lanes 25 m apart.
std::vector<Stem> stand_for(std::size_t frames) {
  SimulateSettings settings;
  settings.area_ha = std::max(1.0, static_cast<double>(frames) * 2.0 * 25.0 / 1e4);
  settings.stems = static_cast<int>(settings.area_ha * 450.0);
  settings.dates = {*parse_date("2020-07-01")};
  settings.drop = 0.0;
  settings.false_stems = 0.0;
  settings.shift_m = 0.0;
  settings.yaw_deg = 0.0;
  return simulate_forest(settings).surveys.front().inventory.stems;
}

FrameSet walk(const std::vector<Stem>& stems, std::uint64_t seed, std::size_t frames) {
  SimulateFramesSettings settings;
  settings.seed = seed;
  auto path = walk_over(stems, settings);
  if (path.size() > frames) path.resize(frames);
  return simulate_frames(stems, path, settings);
}

}  // namespace

FrameSet synthetic_frames(std::size_t frames, std::uint64_t seed, std::size_t most) {
  return walk(stand_for(frames), seed, most);
}

Sequences load_sequences() {
  const char* set = std::getenv("STEMWISE_SHARED_DATA");
  const std::string data = set != nullptr ? set : STEMWISE_SOURCE_DIR "/../shared/data";
  Sequences s;
  if (std::filesystem::exists(data + "/venman-03") && std::filesystem::exists(data + "/venman-04")) {
    s.query_folder = data + "/venman-03";
    s.map_folder = data + "/venman-04";
    s.query = *read_frame_folder(s.query_folder, 1)->frames;
    s.map = *read_frame_folder(s.map_folder, 1)->frames;
    return s;
  }
  std::cerr << "No real sequences at " << data << " (STEMWISE_SHARED_DATA): a synthetic pair instead\n";
  const auto stems = stand_for(1700);
  s.map = walk(stems, 1, 1700);
  s.query = walk(stems, 2, 1700);
  return s;
}

}  // namespace stemwise::benchmarks
