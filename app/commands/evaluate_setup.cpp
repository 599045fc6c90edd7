#include "app/commands/evaluate_setup.hpp"

#include <algorithm>
#include <array>

#include "core/survey/build_global_inventory.hpp"
#include "core/treeloc/prepare_scene.hpp"
#include "io/read_frame_folder.hpp"
#include "io/read_regions.hpp"

namespace stemwise {
namespace {

/// Steps that only one kind of method has, by the first word of their keys.
constexpr std::array only_default{"vote", "verify", "refine", "fuse"};
constexpr std::array only_published{"tdh", "pdh", "retrieve", "outliers", "planar", "roll_pitch", "vertical", "overlap"};

template <class Words>
bool starts_with_one(const Words& words, const std::string& key) {
  return std::any_of(words.begin(), words.end(), [&](const char* word) { return key.starts_with(std::string(word) + "."); });
}

Fields all_fields(treeloc::Settings& settings, treeloc::EvaluateSettings& protocol, std::string& preset) {
  Fields fields = settings.fields();
  for (Field& f : protocol.fields("protocol")) fields.push_back(std::move(f));
  fields.push_back({"preset", "", "auto, plot or route", &preset});
  return fields;
}

}  // namespace

ExitCode EvaluateSetup::check() {
  const auto method = treeloc::method_from(options_.method);
  const bool known_mode = options_.map_mode == "frames" || options_.map_mode == "global";
  if (!method || !known_mode) {
    session_.console.error("methods: stemwise, treeloc++, treeloc; map modes: frames, global");
    return ExitCode::usage;
  }
  method_ = *method;
  if (const ExitCode code = check_settings(); code != ExitCode::done) return code;
  return read_test_regions();
}

ExitCode EvaluateSetup::check_settings() {
  treeloc::Settings tried = treeloc::settings_for(method_, "auto");
  if (const ExitCode code = session_.apply_settings(all_fields(tried, protocol_, preset_)); code != ExitCode::done) return code;
  if (preset_ != "auto" && preset_ != "plot" && preset_ != "route") {
    session_.console.error("presets: auto, plot, route");
    return ExitCode::usage;
  }
  Issues wrong = tried.check();
  for (Issue& issue : protocol_.check()) wrong.push_back(std::move(issue));
  session_.console.issues(as_settings(wrong));
  if (has_error(wrong)) return ExitCode::usage;
  given_ = given_settings(session_.common).values;
  warn_of_unused(given_);
  return ExitCode::done;
}

void EvaluateSetup::warn_of_unused(const SettingTexts& given) const {
  for (const auto& [key, value] : given) {
    const bool is_default = method_ == treeloc::Method::stemwise;
    // A covariance is told of every method, from refine's scales.
    if (is_default ? !starts_with_one(only_published, key) : !starts_with_one(only_default, key) || key.starts_with("refine."))
      continue;
    session_.console.warn(key + " changes nothing: the method " + options_.method + " has no such step" +
                          (is_default ? " (--method treeloc++ has)" : " (--method stemwise has)"));
  }
}

ExitCode EvaluateSetup::read_test_regions() {
  if (options_.regions.empty()) return ExitCode::done;
  const auto colon = options_.regions.rfind(':');
  if (colon == std::string::npos) {
    session_.console.error("--regions takes FILE:KEY");
    return ExitCode::usage;
  }
  auto read = read_regions(options_.regions.substr(0, colon), options_.regions.substr(colon + 1));
  session_.console.issues(read.issues);
  if (!read) return ExitCode::unusable_input;
  regions_ = std::move(*read);
  return ExitCode::done;
}

Result<Inventory> EvaluateSetup::read(const std::string& folder) {
  auto inventory = read_frame_folder(folder, session_.common.threads);
  session_.console.issues(inventory.issues);
  return inventory;
}

treeloc::Settings EvaluateSetup::settings(const SettingTexts& more) const {
  treeloc::Settings settings = treeloc::settings_for(method_, preset_);
  settings.seed = session_.common.seed;
  treeloc::EvaluateSettings protocol;
  std::string preset;
  const Fields fields = all_fields(settings, protocol, preset);
  for (const SettingTexts* texts : {&given_, &more}) {
    for (const auto& [key, value] : *texts) set_field(fields, key, value);
  }
  return settings;
}

std::vector<treeloc::Scene> EvaluateSetup::query_scenes(const FrameSet& frames, const treeloc::Settings& settings) const {
  return treeloc::prepare_frame_scenes(frames, settings.scene, settings.axes, session_.common.threads);
}

std::vector<treeloc::Scene> EvaluateSetup::map_scenes(const FrameSet& frames, const treeloc::Settings& settings) const {
  if (!is_global()) return query_scenes(frames, settings);
  constexpr double grid_spacing_m = 5.0;
  constexpr int grid_min_trees = 10;
  const GlobalInventory global = build_global_inventory(frames, {}, session_.progress().stage(0.05, 0.15));
  return treeloc::prepare_grid_scenes(global.stems, grid_spacing_m, grid_min_trees, settings.scene, settings.axes,
                                      session_.common.threads);
}

}  // namespace stemwise
