#include <chrono>
#include <filesystem>

#include "app/window/autosave.hpp"
#include "app/window/project_io.hpp"
#include "app/window/requests.hpp"
#include "core/project/commands.hpp"
#include "io/same_file.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

JobVerdict take_project(WindowModel& m, const std::string& path, ReadProject read) {
  if (!read.state) {
    m.notices.add_issues(file_name(path) + " could not be opened", read.state.issues);
    m.preferences.forget_project(path);
    offer_recovery(m, path);
    return {false, "not opened"};
  }
  take_up(m, std::move(*read.state), path, std::move(read.stamp), true);
  m.notices.add_issues("Opened " + file_name(path) + " with remarks", read.state.issues);
  m.preferences.remember_project(path);
  if (is_open_elsewhere(m.autosave_file, path)) {
    m.notices.add(Severity::warning, file_name(path) + " is open in another window too",
                  {Issue{Severity::warning, "", 0, "", "What is decided there is not seen here. Whoever saves second is asked, so that nothing is lost.", ""}});
  }
  offer_recovery(m, path);
  return {true, ui::plural(static_cast<std::int64_t>(m.document.state().inventories.size()), "inventory", "inventories")};
}

/// "stand-copy.gpkg" beside the project, or the next name that is free.
std::string copy_beside(const std::string& path) {
  const fs::path p(path);
  std::error_code error;
  for (int n = 1;; ++n) {
    const fs::path copy = p.parent_path() / (p.stem().string() + "-copy" + (n == 1 ? "" : "-" + std::to_string(n)) + p.extension().string());
    if (!fs::exists(copy, error)) return copy.string();
  }
}

void start_save(WindowModel& m, const std::string& path, const std::optional<ProjectStamp>& known);

void save_copy(WindowModel& m, const std::string& path) {
  const std::string copy = copy_beside(path);
  m.notices.add(Severity::note, "Goes on as " + file_name(copy), {Issue{Severity::note, "", 0, "", file_name(path) + " stays beside it, as it was saved elsewhere.", ""}});
  start_save(m, copy, ProjectStamp{});
}

/// Nothing was written: somebody else saved the file since it was read or written here.
void ask_about_changed(WindowModel& m, const std::string& path, const SavedProject& saved) {
  const std::string name = file_name(path);
  const std::string edits = saved.edits_there == 0 ? "" : " It holds " + ui::plural(static_cast<std::int64_t>(saved.edits_there), "edit", "edits") + " that this window does not have.";
  const ui::Question question{name + " was changed elsewhere",
                              "Another window or a command has saved it since it was opened here." + edits + " Replacing it loses what was done there; a copy keeps both.", "Replace it",
                              "Stay", "Save as a copy"};
  ask(m, question, {.yes = [&m, path, there = *saved.changed_to] { start_save(m, path, there); },
                    .no = [&m] { m.leaves_after_saving = false; },
                    .other = [&m, path] { save_copy(m, path); }});
}

JobVerdict take_saved(WindowModel& m, const std::string& path, std::uint64_t revision, const SavedProject& saved) {
  if (saved.changed_to) {
    ask_about_changed(m, path, saved);
    return {false, "not written: the file was changed elsewhere"};
  }
  if (!saved.written) {
    m.notices.add_issues(file_name(path) + " could not be written; nothing is lost", saved.written.issues);
    m.leaves_after_saving = false;
    return {false, "not written"};
  }
  m.preferences.remember_project(path);
  if (!m.document.is_of_this_project(revision)) return {true, "written to " + path};
  m.document.set_path(path, *saved.written);
  m.document.mark_saved(revision);
  remember_underlays(m);
  m.saved_at = std::chrono::steady_clock::now();
  if (std::exchange(m.leaves_after_saving, false) && m.after_leaving && !m.document.is_dirty()) std::exchange(m.after_leaving, nullptr)();
  return {true, "written to " + path};
}

void start_save(WindowModel& m, const std::string& path, const std::optional<ProjectStamp>& known) {
  m.jobs.start<SavedProject>(
      "Save " + file_name(path), JobLane::person,
      [path, known, state = m.document.state()](const Progress& progress) {
        progress.at(0.1, "Writing " + file_name(path));
        return write_project_file(path, state, known);
      },
      [&m, path, revision = m.document.revision()](SavedProject saved) { return take_saved(m, path, revision, saved); });
}

void start_export(WindowModel& m, const ui::request::Export& what) {
  m.jobs.start<Result<Done>>(
      "Export " + file_name(what.path), JobLane::person,
      [what, state = m.document.state()](const Progress& progress) {
        progress.at(0.1, "Writing " + file_name(what.path));
        return write_export(state, what);
      },
      [&m, path = what.path](Result<Done> written) { return tell_written(m, path, written); });
}

void start_report(WindowModel& m, const ui::request::WriteReport& what) {
  m.jobs.start<Result<Done>>(
      "Write " + file_name(what.path), JobLane::person,
      [what, state = m.document.state()](const Progress& progress) {
        progress.at(0.1, "Writing " + file_name(what.path));
        return write_growth_report(state, what);
      },
      [&m, path = what.path](Result<Done> written) { return tell_written(m, path, written); });
}

}  // namespace

JobVerdict tell_written(WindowModel& m, const std::string& path, const Result<Done>& written) {
  if (!written) {
    m.notices.add_issues(file_name(path) + " could not be written", written.issues);
    return {false, "not written"};
  }
  m.notices.add(Severity::note, "Written: " + path, written.issues);
  return {true, "written to " + path};
}

void remember_folder(WindowModel& m, const std::string& path) {
  std::error_code error;
  const fs::path folder = fs::is_directory(path, error) && !fs::exists(fs::path(path) / "trajectory.txt", error) ? fs::path(path) : fs::path(path).parent_path();
  if (!folder.empty()) m.preferences.working_folder = fs::absolute(folder, error).string();
}

void new_project(WindowModel& m) {
  take_up(m, ProjectState{}, "", {}, true);
  m.view.step = ui::Step::inventories;
}

void open_project(WindowModel& m, const std::string& given) {
  std::error_code code;
  const std::string path = std::filesystem::absolute(given, code).lexically_normal().string();  // recent files and recovery outlive the current folder
  remember_folder(m, path);
  m.jobs.start<ReadProject>(
      "Open " + file_name(path), JobLane::person,
      [path](const Progress& progress) {
        progress.at(0.1, "Reading " + file_name(path));
        return read_project_file(path);
      },
      [&m, path](ReadProject read) { return take_project(m, path, std::move(read)); });
}

void save(WindowModel& m) {
  if (m.document.path().empty()) {
    m.view.dialog = ui::Dialog::save_project;
  } else {
    save_as(m, m.document.path());
  }
}

void save_as(WindowModel& m, const std::string& given) {
  std::error_code code;
  const std::string path = fs::absolute(fs::path(given).extension() == ".gpkg" ? given : given + ".gpkg", code).lexically_normal().string();
  remember_folder(m, path);
  if (names_same_file(path, m.document.path())) return start_save(m, path, m.document.stamp());
  const bool is_open = is_open_elsewhere(m.autosave_file, path);
  if (!is_open && !fs::exists(path, code)) return start_save(m, path, std::nullopt);
  const std::string name = file_name(path);
  const std::string what = is_open ? " is a project that is open in another window. What was saved there will be lost."
                                   : " is in " + fs::path(path).parent_path().string() + " already. It is another project, and will be lost.";
  ask(m, {"Replace " + name + "?", name + what, "Replace it", "Keep the old one", ""},
      {.yes = [&m, path] { start_save(m, path, std::nullopt); }, .no = [&m] { m.leaves_after_saving = false; }});
}

void export_layer(WindowModel& m, const ui::request::Export& what) {
  write_over(m, what.path, [&m, what] { start_export(m, what); });
}

void write_report(WindowModel& m, const ui::request::WriteReport& what) {
  write_over(m, what.path, [&m, what] { start_report(m, what); });
}

}  // namespace stemwise
