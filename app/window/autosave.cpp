#include "app/window/autosave.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/platform/folders.hpp"
#include "app/window/window_model.hpp"
#include "io/project_file.hpp"
#include "io/replace_file.hpp"
#include "io/same_file.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string origin_file(const std::string& file) { return file + ".json"; }
std::string lock_file(const std::string& file) { return file + ".lock"; }

Result<Done> keep(const std::string& file, const ProjectState& state, const AutosaveOrigin& origin) {
  std::error_code error;
  fs::create_directories(fs::path(file).parent_path(), error);
  const Json about{{"path", origin.path}, {"title", origin.title}, {"time", origin.time}, {"stamp", origin.stamp}};
  if (Result<Done> told = write_text_file(origin_file(file), about.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"); !told) return told;
  const Result<ProjectStamp> written = write_project(state, file);
  return written ? Result<Done>(Done{}) : Result<Done>::failure(written.issues);
}

/// Nothing known of it: a window that died while it kept its work for the first time.
AutosaveOrigin origin_of(const std::string& file) {
  std::ifstream in(origin_file(file));
  const Json json = in ? Json::parse(in, nullptr, false) : Json();
  if (!json.is_object()) return {"", "Untitled", "", ""};
  const auto text = [&](const char* key) { return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : std::string(); };
  return {text("path"), text("title"), text("time"), text("stamp")};
}

void remove_autosave(const std::string& file) {
  std::error_code error;
  fs::remove(file, error);
  fs::remove(origin_file(file), error);
}

std::vector<std::string> autosaves_newest_first(const std::string& folder) {
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const bool half_written = it->path().filename().string().starts_with(".");
    if (it->path().extension() == ".gpkg" && !half_written) found.emplace_back(it->last_write_time(error), it->path().string());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<std::string> files;
  for (auto& [time, path] : found) files.push_back(std::move(path));
  return files;
}

}  // namespace

Autosave::Autosave(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  const std::string number = folder + "/" + std::to_string(platform::process_id());
  // The number may be that of an earlier process whose work is still here: that name is taken.
  for (int n = 1; n <= 1000 && !lock_; ++n) {
    file_ = number + (n == 1 ? "" : "-" + std::to_string(n)) + ".gpkg";
    lock_ = platform::FileLock::take(lock_file(file_));
    if (lock_ && fs::exists(file_, error)) lock_.reset();
    if (!fs::is_directory(folder, error)) break;
  }
}

void Autosave::tell_others(const std::string& path) {
  if (!lock_ || told_ == path) return;
  told_ = path;
  lock_->write(path);
}

void Autosave::tend(WindowModel& m) {
  tell_others(m.document.path());
  if (!m.document.is_dirty() || m.document.is_empty()) {
    if ((kept_ != 0 || m.rescued) && !m.jobs.is_busy(JobLane::keeper)) forget(m);
    return;
  }
  if (kept_ == m.document.revision() || m.jobs.is_busy(JobLane::keeper)) return;
  kept_ = m.document.revision();
  const AutosaveOrigin origin{m.document.path(), m.document.title(), stamp_now().time_utc, m.document.stamp().text};
  const std::string rescued = m.rescued ? m.rescued->file : "";
  m.jobs.start<Result<Done>>(
      "Autosave", JobLane::keeper, [file = file_, state = m.document.snapshot(), origin](const Progress&) { return keep(file, *state, origin); },
      [&m, rescued](Result<Done> written) -> JobVerdict {
        if (!written) m.notices.add_issues("Autosave could not be written", written.issues);
        if (written && m.rescued && m.rescued->file == rescued) discard(m.rescued);  // it is kept a second time now
        return {static_cast<bool>(written), ""};
      });
}

void Autosave::forget(WindowModel& m) {
  kept_ = 0;
  remove_autosave(file_);
  discard(m.rescued);
}

std::optional<Leftover> take_leftover(const std::string& folder, const std::string& of) {
  for (const std::string& file : autosaves_newest_first(folder)) {
    AutosaveOrigin origin = origin_of(file);
    if (!of.empty() && !names_same_file(origin.path, of)) continue;
    if (auto lock = platform::FileLock::take(lock_file(file))) return Leftover{file, std::move(origin), std::move(*lock)};
  }
  return std::nullopt;
}

bool is_open_elsewhere(const std::string& own_autosave, const std::string& path) {
  std::error_code error;
  for (fs::directory_iterator it(fs::path(own_autosave).parent_path(), error), end; !error && it != end; it.increment(error)) {
    const std::string lock = it->path().string();
    if (it->path().extension() != ".lock" || lock == lock_file(own_autosave) || !platform::is_locked(lock)) continue;
    std::ifstream in(lock);
    const std::string open_there{std::istreambuf_iterator<char>(in), {}};
    if (names_same_file(open_there, path)) return true;
  }
  return false;
}

void discard(std::optional<Leftover>& leftover) {
  if (!leftover) return;
  remove_autosave(leftover->file);
  leftover.reset();  // after its files: nobody finds half of it
}

}  // namespace stemwise
