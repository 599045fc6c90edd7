#include <chrono>
#include <filesystem>

#include "app/window/autosave.hpp"
#include "app/window/project_io.hpp"
#include "app/window/requests.hpp"
#include "core/project/commands.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

void reset_view(WindowModel& m) {
  m.view.selected_tree = {};
  m.view.selected_stem = {};
  m.view.selected_inventory = m.document.state().reference;
  m.view.hidden.clear();
  m.view.only_fate.reset();
  m.view.group.clear();
  m.view.queue = {};
  m.view.tool = ui::Tool::select;
  m.view.underlays.clear();
  m.underlays = {};
  m.view.pairs.clear();
  m.view.ghost = m.view.before_after = m.view.slide = false;
  m.view.placement = {};
  m.previews.forget();
  m.status.placement.reset();
  m.status.fusion.reset();
  m.status.rules.reset();
  m.status.exporting.reset();
  m.status.reporting.reset();
  m.status.page.reset();
  m.walk = {};
}

void show_fitting_step(WindowModel& m) {
  const ProjectState& state = m.document.state();
  bool placed = false;
  for (const auto& inventory : state.inventories) placed = placed || (inventory->id != state.reference && state.is_placed(inventory->id));
  m.view.step = placed ? ui::Step::review : state.inventories.size() >= 2 ? ui::Step::align : ui::Step::inventories;
}

JobVerdict take_project(WindowModel& m, const std::string& path, Result<ProjectState> read) {
  m.notices.add_issues(read ? "Opened " + file_name(path) + " with remarks" : file_name(path) + " could not be opened", read.issues);
  if (!read) {
    m.preferences.forget_project(path);
    return {false, "not opened"};
  }
  remember_underlays(m);
  m.document.replace(std::move(*read), path, true);
  m.preferences.remember_project(path);
  m.saved_at.reset();
  reset_view(m);
  show_fitting_step(m);
  restore_underlays(m);
  return {true, ui::plural(static_cast<std::int64_t>(m.document.state().inventories.size()), "inventory", "inventories")};
}

JobVerdict take_saved(WindowModel& m, const std::string& path, std::uint64_t revision, const Result<Done>& written) {
  if (!written) {
    m.notices.add_issues(file_name(path) + " could not be written; nothing is lost", written.issues);
    m.leaves_after_saving = false;
    return {false, "not written"};
  }
  m.document.set_path(path);
  m.document.mark_saved(revision);
  m.preferences.remember_project(path);
  remember_underlays(m);
  m.saved_at = std::chrono::steady_clock::now();
  if (std::exchange(m.leaves_after_saving, false) && m.after_leaving && !m.document.is_dirty()) std::exchange(m.after_leaving, nullptr)();
  return {true, "written to " + path};
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
  remember_underlays(m);
  m.document.replace(ProjectState{}, "", true);
  reset_view(m);
  m.view.step = ui::Step::inventories;
}

void open_project(WindowModel& m, const std::string& given) {
  std::error_code code;
  const std::string path = std::filesystem::absolute(given, code).lexically_normal().string();  // recent files and recovery outlive the current folder
  remember_folder(m, path);
  m.jobs.start<Result<ProjectState>>(
      "Open " + file_name(path), JobLane::person,
      [path](const Progress& progress) {
        progress.at(0.1, "Reading " + file_name(path));
        return read_project_file(path);
      },
      [&m, path](Result<ProjectState> read) { return take_project(m, path, std::move(read)); });
}

void save(WindowModel& m) {
  if (m.document.path().empty()) {
    m.view.dialog = ui::Dialog::save_project;
  } else {
    save_as(m, m.document.path());
  }
}

void save_as(WindowModel& m, const std::string& given) {
  const std::string path = fs::path(given).extension() == ".gpkg" ? given : given + ".gpkg";
  remember_folder(m, path);
  m.jobs.start<Result<Done>>(
      "Save " + file_name(path), JobLane::person,
      [path, state = m.document.state()](const Progress& progress) {
        progress.at(0.1, "Writing " + file_name(path));
        return write_project_file(path, state);
      },
      [&m, path, revision = m.document.revision()](Result<Done> written) { return take_saved(m, path, revision, written); });
}

void export_layer(WindowModel& m, const ui::request::Export& what) {
  write_over(m, what.path, [&m, what] { start_export(m, what); });
}

void write_report(WindowModel& m, const ui::request::WriteReport& what) {
  write_over(m, what.path, [&m, what] { start_report(m, what); });
}

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

void answer_recovery(WindowModel& m, bool bring_back) {
  m.view.dialog = ui::Dialog::none;
  if (!bring_back) {
    ask(m, {"Throw the unsaved work away?", m.status.recovery_text + " It cannot be brought back afterwards.", "Throw it away", "Keep it"},
        [&m] { discard_autosave(std::exchange(m.recovered_file, "")); }, [&m] { m.view.dialog = ui::Dialog::recover; });
    return;
  }
  const std::string file = std::exchange(m.recovered_file, "");
  m.jobs.start<Result<ProjectState>>(
      "Bring back unsaved work", JobLane::person, [file](const Progress&) { return read_project_file(file); },
      [&m, file](Result<ProjectState> read) -> JobVerdict {
        m.notices.add_issues("What autosave kept could not be read", read ? Issues{} : read.issues);
        if (!read) return {false, "not readable"};
        m.document.replace(std::move(*read), autosave_origin(file).path, false);
        reset_view(m);
        show_fitting_step(m);
        restore_underlays(m);
        discard_autosave(file);
        return {true, "brought back"};
      });
}

}  // namespace stemwise
