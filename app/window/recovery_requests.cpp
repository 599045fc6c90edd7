#include <filesystem>
#include <memory>

#include "app/platform/folders.hpp"
#include "app/window/project_io.hpp"
#include "app/window/requests.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

std::string words_for(const Leftover& leftover) {
  const AutosaveOrigin& origin = leftover.origin;
  const std::string when = origin.time.empty() ? "" : ", last changed " + platform::local_time(origin.time) + ",";
  std::string where = origin.path.empty() ? " was never saved to a file." : " has changes that are not in " + origin.path + ".";
  std::error_code error;
  const bool later = !origin.path.empty() && fs::exists(origin.path, error) && fs::last_write_time(origin.path, error) > fs::last_write_time(leftover.file, error);
  if (later) where += " That file was written again after these changes.";
  return "\"" + origin.title + "\"" + when + where;
}

void bring_back(WindowModel& m) {
  const auto held = std::make_shared<Leftover>(std::move(*m.leftover));
  m.leftover.reset();
  m.jobs.start<ReadProject>(
      "Bring back unsaved work", JobLane::person, [file = held->file](const Progress&) { return read_project_file(file); },
      [&m, held](ReadProject read) -> JobVerdict {
        if (!read.state) {
          m.notices.add_issues("What autosave kept could not be read", read.state.issues);
          return {false, "not readable"};  // its files stay
        }
        take_up(m, std::move(*read.state), held->origin.path, {held->origin.stamp}, false);
        m.rescued = std::move(*held);
        return {true, "brought back"};
      });
}

}  // namespace

void offer_recovery(WindowModel& m, const std::string& of) {
  if (m.autosave_folder.empty()) return;
  m.leftover = take_leftover(m.autosave_folder, of);
  if (!m.leftover) return;
  m.status.recovery_text = words_for(*m.leftover);
  m.view.dialog = ui::Dialog::recover;
}

void answer_recovery(WindowModel& m, ui::RecoveryAnswer answer) {
  m.view.dialog = ui::Dialog::none;
  if (!m.leftover) return;
  switch (answer) {
    case ui::RecoveryAnswer::bring_back: return bring_back(m);
    case ui::RecoveryAnswer::not_now: m.leftover.reset(); return;
    case ui::RecoveryAnswer::throw_away:
      ask(m, {"Throw the unsaved work away?", m.status.recovery_text + " It cannot be brought back afterwards.", "Throw it away", "Keep it", ""},
          {.yes = [&m] { discard(m.leftover); }, .no = [&m] { m.view.dialog = ui::Dialog::recover; }});
  }
}

}  // namespace stemwise
