#include "app/window/autosave.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/platform/folders.hpp"
#include "app/window/project_io.hpp"
#include "app/window/window_model.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string origin_file(const std::string& file) { return file + ".json"; }

Result<Done> keep(const std::string& file, const ProjectState& state, const AutosaveOrigin& origin) {
  std::error_code error;
  fs::create_directories(fs::path(file).parent_path(), error);
  Result<Done> written = write_project_file(file, state);
  if (!written) return written;
  std::ofstream out(origin_file(file));
  out << Json{{"path", origin.path}, {"title", origin.title}, {"time", origin.time}, {"process", origin.process}}.dump() << "\n";
  return written;
}

}  // namespace

Autosave::Autosave(std::string folder) : file_(std::move(folder) + "/" + std::to_string(platform::process_id()) + ".gpkg") {}

void Autosave::tend(WindowModel& m) {
  if (!m.document.is_dirty() || m.document.is_empty()) {
    if (kept_ != 0 && !m.jobs.is_busy(JobLane::keeper)) forget();
    return;
  }
  if (kept_ == m.document.revision() || m.jobs.is_busy(JobLane::keeper)) return;
  kept_ = m.document.revision();
  const AutosaveOrigin origin{m.document.path(), m.document.title(), stamp_now().time_utc, platform::process_id()};
  m.jobs.start<Result<Done>>(
      "Autosave", JobLane::keeper, [file = file_, state = m.document.snapshot(), origin](const Progress&) { return keep(file, *state, origin); },
      [&m](Result<Done> written) -> JobVerdict {
        if (!written) m.notices.add_issues("Autosave could not be written", written.issues);
        return {static_cast<bool>(written), ""};
      });
}

void Autosave::forget() {
  kept_ = 0;
  discard_autosave(file_);
}

std::vector<std::string> orphaned_autosaves(const std::string& folder) {
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() != ".gpkg") continue;
    const AutosaveOrigin origin = autosave_origin(it->path().string());
    if (origin.process == 0 || origin.process == platform::process_id() || platform::process_runs(origin.process)) continue;
    found.emplace_back(it->last_write_time(error), it->path().string());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<std::string> files;
  for (auto& [time, path] : found) files.push_back(std::move(path));
  return files;
}

AutosaveOrigin autosave_origin(const std::string& file) {
  std::ifstream in(origin_file(file));
  if (!in) return {};
  try {
    const Json json = Json::parse(in);
    return {json.value("path", ""), json.value("title", ""), json.value("time", ""), json.value("process", 0)};
  } catch (const Json::exception&) {
    return {};
  }
}

void discard_autosave(const std::string& file) {
  std::error_code error;
  fs::remove(file, error);
  fs::remove(origin_file(file), error);
}

}  // namespace stemwise
