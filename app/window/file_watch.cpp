#include "app/window/file_watch.hpp"

#include "app/window/requests.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
constexpr double pause_s = 3.0;

void tell(WindowModel& m) {
  const std::string path = m.document.path(), name = fs::path(path).filename().string();
  m.changed_elsewhere = m.document.stamp();
  m.notices.add(Severity::warning, name + " was changed elsewhere",
                {Issue{Severity::warning, "", 0, "", "Another window or a command has saved it. What it holds now is not seen here; saving asks before anything of it is lost.", ""}},
                {{"Open it again", [&m, path] { leave_then(m, [&m, path] { open_project(m, path); }); }}, {"Go on", {}}});
}

}  // namespace

void FileWatch::tend(WindowModel& m, double elapsed_s) {
  waited_s_ += elapsed_s;
  if (waited_s_ < pause_s || m.document.path().empty() || m.jobs.is_busy(JobLane::person)) return;
  waited_s_ = 0.0;
  std::error_code error;
  const fs::file_time_type now = fs::last_write_time(m.document.path(), error);
  if (error || (path_ == m.document.path() && now == seen_)) return;
  path_ = m.document.path();
  seen_ = now;
  m.jobs.start<bool>(
      "Look at the file", JobLane::keeper, [path = path_, stamp = m.document.stamp()](const Progress&) { return is_changed_since(stamp, path); },
      [this, &m, stamp = m.document.stamp(), path = path_](bool changed) {
        const bool is_old = m.jobs.is_busy(JobLane::person) || m.document.path() != path || m.document.stamp() != stamp;
        if (is_old) path_.clear();  // once more, later
        else if (changed && !is_changed_elsewhere(m)) tell(m);
        return JobVerdict{};
      });
}

bool is_changed_elsewhere(const WindowModel& m) { return m.changed_elsewhere && *m.changed_elsewhere == m.document.stamp(); }

}  // namespace stemwise
