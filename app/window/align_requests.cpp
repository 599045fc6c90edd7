#include <cstdlib>

#include "app/align_job.hpp"
#include "app/window/requests.hpp"
#include "core/project/commands.hpp"
#include "core/project/rough_pose_key.hpp"
#include "core/survey/unit_doubt.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

/// The project's settings, by the keys that --set takes; what does not fit is told.
AlignJobSettings settings_of(const ProjectState& state, Issues& issues) {
  AlignJobSettings settings;
  const Fields fields = settings.fields();
  for (const auto& [key, value] : state.settings) {
    if (key == "preset") {
      settings.align.preset = value;
    } else if (key == "seed") {
      settings.align.seed = std::strtoull(value.c_str(), nullptr, 10);
    } else if (key == "accept_probable") {
      settings.align.accept_probable = value == "true";
    } else if (!key.starts_with("rules.") && !is_rough_pose_key(key)) {  // rules are for the tables, not for the alignment
      const Issues wrong = set_field(fields, key, value);
      issues.insert(issues.end(), wrong.begin(), wrong.end());
    }
  }
  return settings;
}

std::string sentence_of(const ProjectState& state) {
  int aligned = 0, others = 0;
  for (const auto& inventory : state.inventories) {
    if (inventory->id == state.reference) continue;
    ++others;
    aligned += state.is_placed(inventory->id) ? 1 : 0;
  }
  return std::to_string(aligned) + " of " + std::to_string(others) + " aligned to the reference";
}

/// One notice for all surveys of this status.
void tell_all(WindowModel& m, AlignmentStatus status, const std::string& what, const std::string& help) {
  const ProjectState& state = m.document.state();
  std::vector<std::string> names;
  Issues reasons;
  for (const auto& [id, alignment] : state.alignments) {
    if (alignment.status != status) continue;
    const Inventory* inventory = state.find(id);
    names.push_back(inventory != nullptr ? inventory->name : "An inventory");
    reasons.push_back(Issue{Severity::warning, "", 0, "", names.back() + ": " + alignment.reason, ""});
    m.view.selected_inventory = id;
  }
  if (names.empty()) return;
  reasons.back().help = help;
  m.notices.add(Severity::warning, (names.size() == 1 ? names.front() : std::to_string(names.size()) + " surveys") + what, reasons);
}

void tell_refusals(WindowModel& m) {
  tell_all(m, AlignmentStatus::failed, " could not be aligned", "Step 2 offers ways to help along.");
  tell_all(m, AlignmentStatus::probable, " could be aligned, but not with certainty", "Look at the proposed pose in step 2 and accept it, or help along.");
}

JobVerdict take_alignment(WindowModel& m, std::uint64_t revision, AlignOutcome outcome) {
  if (m.document.revision() != revision) return {false, "The project was changed meanwhile: align again"};
  const std::vector<std::string> notes = outcome.alignment.notes;
  apply_with_named_pairs(m, std::move(outcome));
  tell_refusals(m);
  Issues doubts;
  for (const std::string& doubt : unit_doubts(m.document.state())) doubts.push_back(Issue{Severity::warning, "", 0, "", doubt, "Remove that survey and add it again with its unit (Import with options)."});
  m.notices.add_issues("Diameters that do not fit each other", doubts);
  Issues remarks;
  for (const std::string& note : notes) remarks.push_back(Issue{Severity::note, "", 0, "", note, ""});
  if (!remarks.empty()) m.notices.add(Severity::note, "How the surveys were aligned", remarks);
  m.view.mode = ui::ViewMode::map;
  const std::string sentence = sentence_of(m.document.state());
  if (!sentence.starts_with("0 ")) {
    m.view.step = ui::Step::review;
    m.view.tab = ui::BottomTab::queue;
  }
  return {true, sentence};
}

}  // namespace

void run_alignment(WindowModel& m) {
  Issues issues;
  const AlignJobSettings settings = settings_of(m.document.state(), issues);
  m.notices.add_issues("Some settings were left out", issues);
  AlignHints hints;
  forget_used_pairs(m);
  for (const auto& [known, other] : m.view.pairs) hints.same_tree.push_back({known, other});
  m.view.step = ui::Step::align;
  m.view.panels.show_right = true;
  const auto surveys = static_cast<std::int64_t>(m.document.state().inventories.size());
  m.jobs.start<AlignOutcome>(
      "Align " + ui::plural(surveys, "survey", "surveys"), JobLane::person,
      [state = m.document.state(), settings, hints](const Progress& progress) { return align_project(state, settings, hints, progress); },
      [&m, revision = m.document.revision()](AlignOutcome outcome) { return take_alignment(m, revision, std::move(outcome)); });
}

}  // namespace stemwise
