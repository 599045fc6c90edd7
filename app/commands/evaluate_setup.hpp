#pragma once
#include <string>
#include <utility>
#include <vector>

#include "app/session.hpp"
#include "core/base/result.hpp"
#include "core/forest/inventory.hpp"
#include "core/geometry/polygon.hpp"
#include "core/treeloc/evaluate.hpp"

namespace stemwise {

/// What every form of `evaluate` takes.
struct EvaluateMethodOptions {
  std::string method = "stemwise";  ///< stemwise, treeloc++, treeloc
  std::string map_mode = "frames";  ///< frames, or global: the map's trees as one list, cut on a grid
  std::string regions;              ///< FILE:KEY; empty: every query counts
};

/// Settings by key and text, such as `--set` gives them.
using SettingTexts = std::vector<std::pair<std::string, std::string>>;

/// Method, settings, test regions and scenes, checked once and used by every form of `evaluate`.
class EvaluateSetup {
 public:
  EvaluateSetup(const EvaluateMethodOptions& options, Session& session) : options_(options), session_(session) {}

  /// Everything that can be wrong before a frame is read; says so. Warns of settings that the method does not use.
  ExitCode check();
  Result<Inventory> read(const std::string& folder);
  /// The method's settings: the preset, then `--config` and `--set`, then `more`.
  treeloc::Settings settings(const SettingTexts& more = {}) const;
  std::vector<treeloc::Scene> query_scenes(const FrameSet& frames, const treeloc::Settings& settings) const;
  /// Frames, or with `--map-mode global` the survey's trees as one list, cut on a 5 m grid (the paper's section IV-E).
  std::vector<treeloc::Scene> map_scenes(const FrameSet& frames, const treeloc::Settings& settings) const;

  bool is_global() const { return options_.map_mode == "global"; }
  const treeloc::EvaluateSettings& protocol() const { return protocol_; }
  const std::vector<Polygon>& regions() const { return regions_; }
  std::string regions_file() const { return options_.regions.substr(0, options_.regions.rfind(':')); }
  Session& session() const { return session_; }

 private:
  ExitCode check_settings();
  ExitCode read_test_regions();
  void warn_of_unused(const SettingTexts& given) const;

  const EvaluateMethodOptions& options_;
  Session& session_;
  treeloc::Method method_ = treeloc::Method::stemwise;
  std::string preset_ = "auto";
  SettingTexts given_;
  treeloc::EvaluateSettings protocol_;
  std::vector<Polygon> regions_;
};

}  // namespace stemwise
