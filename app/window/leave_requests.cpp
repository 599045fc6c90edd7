#include <algorithm>

#include "app/window/requests.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

void close(WindowModel& m) {
  leave_then(m, [&m] { m.wants_close = true; });
}

void ask_about_imports(WindowModel& m) {
  const std::string files = ui::plural(static_cast<std::int64_t>(m.imports.size()), "file", "files");
  ask(m, {"Quit without adding " + files + "?", "The import is not finished: what you set for " + files + " would be lost.", "Quit", "Go on with the import", ""},
      {.yes = [&m] {
        finish_import(m, false);
        close(m);
      }});
}

}  // namespace

void leave_then(WindowModel& m, std::function<void()> next) {
  if (!m.document.is_dirty() || m.document.is_empty()) {
    next();
    return;
  }
  m.after_leaving = std::move(next);
  m.view.dialog = ui::Dialog::leave;
}

void answer_leave(WindowModel& m, bool save_first) {
  m.view.dialog = ui::Dialog::none;
  if (save_first) {
    m.leaves_after_saving = true;
    save(m);
  } else if (m.after_leaving) {
    std::exchange(m.after_leaving, nullptr)();
  }
}

void quit(WindowModel& m) {
  if (m.view.dialog == ui::Dialog::question) answer_question(m, ui::Answer::no);
  if (m.view.dialog == ui::Dialog::recover) answer_recovery(m, ui::RecoveryAnswer::not_now);
  const bool edited = std::any_of(m.imports.begin(), m.imports.end(), [](const PendingImport& p) { return p.edited; });
  if (m.view.dialog == ui::Dialog::import && edited) return ask_about_imports(m);
  if (m.view.dialog == ui::Dialog::import) finish_import(m, false);
  m.view.dialog = ui::Dialog::none;
  close(m);
}

}  // namespace stemwise
