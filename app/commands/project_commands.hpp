#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/session.hpp"
#include "core/project/project_state.hpp"

namespace stemwise {

struct ReportCommandOptions {
  std::string project;
  std::string output;
  std::optional<double> area_ha;
  double class_width_cm = 5.0;
  std::string rules;              ///< a built-in pack, "none", or a JSON file; empty: as the project has it
  bool field_check = false;
  std::size_t field_check_trees = 100;
};
/// `stemwise report PROJECT -o FILE`: the growth report, format by suffix.
ExitCode run_report(const ReportCommandOptions& options, Session& session);

struct MergeOptions {
  std::string project;
  std::string policy = "min-dbh";
};
/// `stemwise merge PROJECT`: sets the fusion policy.
ExitCode run_merge(const MergeOptions& options, Session& session);

struct RemoveOptions {
  std::string project;
  std::vector<std::string> inventories;  ///< by name
  std::string output;                    ///< empty: the project itself
};
/// `stemwise remove PROJECT INVENTORY...`: takes surveys out of a project; what the others have stays as it is.
ExitCode run_remove(const RemoveOptions& options, Session& session);

struct SnapshotOptions {
  std::string project;
  std::string output;
  std::string view = "map";
  std::string color_by = "fate";
  int width_px = 1600, height_px = 1000;
  bool dark = false;
};
/// `stemwise snapshot PROJECT -o PNG`: a picture, without a display.
ExitCode run_snapshot(const SnapshotOptions& options, Session& session);

}  // namespace stemwise
