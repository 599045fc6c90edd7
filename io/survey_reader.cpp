#include "io/survey_reader.hpp"

#include <algorithm>
#include <chrono>

#include "core/base/parallel.hpp"
#include "core/treeloc/prepare_scene.hpp"
#include "core/treeloc/sensor_height.hpp"
#include "io/folder_stamp.hpp"
#include "io/frame_folder.hpp"

namespace stemwise {
namespace {

using Clock = std::chrono::steady_clock;

/// Adds the time of its life to a sum.
class Timer {
 public:
  explicit Timer(double& sum_s) : sum_s_(sum_s) {}
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  ~Timer() { sum_s_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  double& sum_s_;
  Clock::time_point start_ = Clock::now();
};

std::int64_t system_now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

void append(Issues& all, Issues more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::string text_of(const Fields& fields) {
  std::string text;
  for (const Field& field : fields) text += field.key + "=" + field_text(field) + "\n";
  return text;
}

/// Scenes of frames that come one after the other: keeps the last ones, whose trees may fill up those that follow.
class SceneStream {
 public:
  SceneStream(const treeloc::Settings& settings, int threads) : settings_(settings), threads_(threads) {}

  void add(std::vector<Frame> frames) {
    const std::size_t kept = window_.frames.size(), first = scenes_.size();
    std::move(frames.begin(), frames.end(), std::back_inserter(window_.frames));
    scenes_.resize(first + frames.size());
    parallel_for(frames.size(), threads_, [&](std::size_t i) {
      scenes_[first + i] = treeloc::prepare_frame_scene(window_, kept + i, settings_.scene, settings_.axes);
    });
    const auto needed = static_cast<std::size_t>(std::max(0, settings_.scene.preceding_frames));
    const std::size_t surplus = window_.frames.size() - std::min(needed, window_.frames.size());
    window_.frames.erase(window_.frames.begin(), window_.frames.begin() + static_cast<std::ptrdiff_t>(surplus));
  }

  std::vector<treeloc::Scene> finish() {
    treeloc::mark_level_sensor(scenes_, settings_.scene.sensor);
    return std::move(scenes_);
  }

 private:
  const treeloc::Settings& settings_;
  int threads_;
  FrameSet window_;
  std::vector<treeloc::Scene> scenes_;
};

}  // namespace

SurveyReader::SurveyReader(SurveyCacheOptions options, int threads) : options_(std::move(options)), threads_(threads) {
  if (!options_.folder.empty()) cache_.emplace(options_.folder, options_.most_bytes);
  if (!options_.now_ns) options_.now_ns = system_now_ns;
}

std::optional<SurveyReader::Keys> SurveyReader::keys_of(const std::string& folder, treeloc::Settings settings) const {
  constexpr const char* layout = "scenes and triangles 1\n";  // to be counted up when what is kept means something else
  if (!cache_) return std::nullopt;
  const std::int64_t now_ns = options_.now_ns();
  const auto stamp = frame_folder_stamp(folder);
  if (!stamp || !stamp->is_settled(now_ns)) return std::nullopt;
  Keys keys;
  keys.scenes = layout + options_.program + "\n" + folder + "\n" + text_of(settings.scene.fields("scene")) + text_of(settings.axes.fields("axes")) + stamp->bytes;
  keys.triangles = text_of(settings.triangles.fields("triangles")) + keys.scenes;
  return keys;
}

bool SurveyReader::take_from_cache(const Keys& keys, bool with_triangles, ReadSurvey& survey, Issues& issues) const {
  const Timer timer(survey.read_s);
  auto found = cache_->find_scenes(keys.scenes);
  if (!found) return false;
  survey.name = std::move(found->name);
  survey.described.scenes = std::move(found->scenes);
  survey.scenes_from_cache = true;
  issues = std::move(found->issues);
  if (with_triangles) survey.described.triangles = cache_->find_triangles(keys.triangles);
  const auto& triangles = survey.described.triangles;
  if (triangles && triangles->scene_count != survey.described.scenes.size()) survey.described.triangles = nullptr;
  survey.triangles_from_cache = survey.described.triangles != nullptr;
  return true;
}

Result<ReadSurvey> SurveyReader::read_frames(const std::string& folder, const treeloc::Settings& settings) const {
  constexpr std::size_t frames_at_once = 64;  // a few megabytes, used again and again
  ReadSurvey survey;
  Result<FrameFolder> opened;
  {
    const Timer timer(survey.read_s);
    opened = FrameFolder::open(folder);
  }
  if (!opened) return Result<ReadSurvey>::failure(std::move(opened.issues));
  Issues issues = std::move(opened.issues);
  SceneStream stream(settings, threads_);
  bool usable = false;
  for (std::size_t first = 0; first < opened->size(); first += frames_at_once) {
    Result<std::vector<Frame>> frames;
    {
      const Timer timer(survey.read_s);
      frames = opened->read(first, frames_at_once, threads_);
    }
    const Timer timer(survey.describe_s);
    append(issues, std::move(frames.issues));
    usable = usable || std::any_of(frames->begin(), frames->end(), [](const Frame& f) { return !f.stems.empty(); });
    stream.add(std::move(*frames));
  }
  if (!usable) {
    issues.push_back(opened->nothing_usable());
    return Result<ReadSurvey>::failure(std::move(issues));
  }
  survey.name = opened->name();
  survey.described.scenes = stream.finish();
  return {std::move(survey), std::move(issues)};
}

Result<ReadSurvey> SurveyReader::read(const std::string& folder, const treeloc::Settings& settings, bool with_triangles) const {
  double looking_s = 0.0;
  std::optional<Keys> keys;
  {
    const Timer timer(looking_s);
    keys = keys_of(folder, settings);
  }
  Result<ReadSurvey> result;
  ReadSurvey cached;
  if (keys && take_from_cache(*keys, with_triangles, cached, result.issues)) {
    result.value.emplace(std::move(cached));
  } else {
    result = read_frames(folder, settings);
    if (!result) return result;
  }
  ReadSurvey& survey = *result;
  survey.read_s += looking_s;
  if (with_triangles && !survey.described.triangles) {
    const Timer timer(survey.describe_s), of_it(survey.index_s);
    survey.described.triangles =
        std::make_shared<treeloc::IndexSegment>(treeloc::index_scenes(survey.described.scenes, settings.triangles, threads_));
  }
  const Timer timer(survey.keep_s);
  const bool all_there = survey.scenes_from_cache && (survey.triangles_from_cache || !with_triangles);
  if (!keys || all_there) return result;
  const auto still = keys_of(folder, settings);  // a file that changed meanwhile may be half of each
  if (!still || still->triangles != keys->triangles) return result;
  if (!survey.scenes_from_cache) cache_->keep_scenes(keys->scenes, {survey.name, result.issues, survey.described.scenes});
  if (with_triangles && !survey.triangles_from_cache) cache_->keep_triangles(keys->triangles, *survey.described.triangles);
  return result;
}

}  // namespace stemwise
