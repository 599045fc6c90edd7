#pragma once
#include <cstdint>
#include <optional>

#include "core/survey/rule_pack.hpp"
#include "ui/previews.hpp"

namespace stemwise {

struct WindowModel;

/// Works out what the forms of steps 4 and 5 would do, beside the window: one after the other, each again when the project or
/// its form has changed. The answers go into the window's status; nothing is applied.
class Previews {
 public:
  /// Every frame: starts what is out of date in the step that is shown.
  void tend(WindowModel& model);
  void forget();  ///< another project

  std::optional<RulePack> own_rules;  ///< read from a person's file

 private:
  bool start_fusion(WindowModel& model);
  bool start_placement(WindowModel& model);
  bool start_rules(WindowModel& model);
  bool start_export(WindowModel& model);
  bool start_report(WindowModel& model);

  // What was asked for last: a job that fails is not started again and again.
  std::uint64_t fusion_of_ = 0, rules_of_ = 0;
  std::string own_of_;
  std::pair<std::uint64_t, ui::PlacementForm> placement_of_;
  std::pair<std::uint64_t, ui::ExportForm> export_of_;
  std::pair<std::uint64_t, double> report_of_;
};

/// Whether the form says enough to work anything out.
bool is_complete(const ui::PlacementForm& form);
ui::PlacementPreview preview_placement(const ui::PlacementForm& form, const ProjectState& state);
ui::ExportPreview preview_export(const ui::ExportForm& form, const ProjectState& state, const Tables& tables);
ui::ReportPreview preview_report(double area_ha, const ProjectState& state, const Tables& tables);

}  // namespace stemwise
