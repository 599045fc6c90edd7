#include <algorithm>
#include <filesystem>

#include "app/window/requests.hpp"
#include "io/underlay/read_cloud_underlay.hpp"
#include "io/underlay/read_raster_underlay.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;
constexpr double least_margin_m = 30.0;
constexpr double margin_share = 0.25;

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

struct ReadUnderlay {
  std::optional<UnderlayData> data;
  Issues issues;
};

template <class Underlay>
ReadUnderlay shared(Result<Underlay> read) {
  ReadUnderlay out{{}, std::move(read.issues)};
  if (read) out.data = std::make_shared<const Underlay>(std::move(*read));
  return out;
}

ReadUnderlay read(const UnderlayRequest& request, bool is_cloud, const Progress& progress) {
  return is_cloud ? shared(read_cloud_underlay(request, progress)) : shared(read_raster_underlay(request, progress));
}

/// Around all stems that have a place, with a margin.
Eigen::AlignedBox2d area_of(const Tables& tables) {
  Eigen::AlignedBox2d area;
  for (const ObservationRow& row : tables.observations) area.extend(row.position_m.head<2>());
  if (area.isEmpty()) return area;
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(std::max(least_margin_m, margin_share * area.sizes().maxCoeff()));
  return {area.min() - margin, area.max() + margin};
}

UnderlayRequest request_of(const WindowModel& m, const ui::Underlay& underlay) {
  const ProjectState& state = m.document.state();
  UnderlayRequest request{underlay.path, state.georeference, {}, area_of(m.document.derived().tables)};
  const bool is_turned = underlay.frame != state.reference && state.find(underlay.frame) && state.is_placed(underlay.frame);
  if (is_turned) request.reference_from_local = state.reference_from_inventory(underlay.frame);
  return request;
}

std::string words_for(const RasterUnderlay& r) {
  const std::string system = r.system.empty() ? "local coordinates" : r.system;
  return (r.is_terrain ? "Shaded relief, " : "") + ui::fixed(r.pixel_m, r.pixel_m < 0.1 ? 3 : 2) + " m per pixel; " + system;
}

std::string words_for(const CloudUnderlay& c) {
  const std::string system = c.system.empty() ? "local coordinates" : c.system;
  return ui::count_text(c.points_in_file) + " points, " + ui::count_text(static_cast<std::int64_t>(c.points.size())) + " kept, one per " + ui::fixed(100.0 * c.spacing_m, 0) + " cm; " + system;
}

void show(ui::Underlay& u, const UnderlayData& data) {
  u.is_local = std::visit([](const auto& read) { return read->system.empty(); }, data);
  const bool is_new = u.state != ui::Underlay::State::shown && !u.is_remembered;
  u.state = ui::Underlay::State::shown;
  if (const auto* raster = std::get_if<0>(&data)) {
    u.about = words_for(**raster);
    return;
  }
  const CloudUnderlay& cloud = *std::get<1>(data);
  u.about = words_for(cloud);
  u.has_colour = cloud.has_colour;
  u.has_intensity = cloud.has_intensity;
  if (is_new) u.shade = cloud.has_colour ? ui::CloudShade::colour : ui::CloudShade::height;
}

/// A new one goes again. One that was there before stays in the list: a disk may be missing today, a georeference tomorrow
/// be back.
void leave_unread(WindowModel& m, int id, const std::string& why) {
  const auto u = std::find_if(m.view.underlays.begin(), m.view.underlays.end(), [id](const ui::Underlay& one) { return one.id == id; });
  if (!u->is_remembered) return remove_underlay(m, id);
  u->state = ui::Underlay::State::failed;
  u->about = why;
  m.underlays.fail(id);
}

JobVerdict refuse(WindowModel& m, int id, const std::string& path, const Issues& issues) {
  m.notices.add(Severity::error, file_name(path) + " cannot be laid under the stems", issues);
  leave_unread(m, id, issues.empty() ? "It could not be read" : issues.front().text);
  return {false, "not read"};
}

JobVerdict arrived(WindowModel& m, int id, int reading, ReadUnderlay read) {
  const auto u = std::find_if(m.view.underlays.begin(), m.view.underlays.end(), [id](const ui::Underlay& one) { return one.id == id; });
  if (u == m.view.underlays.end() || !m.underlays.is_awaited(id, reading)) return {true, "no longer wanted"};
  if (!read.data) return refuse(m, id, u->path, read.issues);
  m.notices.add_issues(file_name(u->path) + " was read with remarks", read.issues);
  m.underlays.take(id, *read.data);
  show(*u, *read.data);
  u->is_remembered = true;
  remember_underlays(m);
  return {true, u->about};
}

void start_reading(WindowModel& m, ui::Underlay& u) {
  UnderlayRequest request = request_of(m, u);
  if (request.area_in_reference_m.isEmpty()) return;
  u.state = ui::Underlay::State::reading;
  u.about = "Being read";
  if (const auto earlier = m.underlays.job_of(u.id)) m.jobs.cancel(*earlier);
  const int reading = m.underlays.begin(u.id, u.frame, request);
  const int job = m.jobs.start<ReadUnderlay>(
      "Read " + file_name(u.path), JobLane::person, [request, is_cloud = u.is_cloud](const Progress& progress) { return read(request, is_cloud, progress); },
      [&m, id = u.id, reading](ReadUnderlay result) { return arrived(m, id, reading, std::move(result)); });
  m.underlays.set_job(u.id, job);
}

/// A person cancelled the reading, or it failed from within: without a result nobody would be told.
bool was_given_up(const WindowModel& m, const ui::Underlay& u) {
  const std::optional<int> job = m.underlays.job_of(u.id);
  if (u.state != ui::Underlay::State::reading || !job) return false;
  const std::vector<ui::JobView> jobs = m.jobs.views();
  const auto view = std::find_if(jobs.begin(), jobs.end(), [&](const ui::JobView& one) { return one.id == *job; });
  return view == jobs.end() || view->state == ui::JobView::State::cancelled || view->state == ui::JobView::State::failed;
}

}  // namespace

void add_underlays(WindowModel& m, const std::vector<std::string>& paths) {
  std::error_code code;
  for (const std::string& given : paths) {
    const auto kind = underlay_kind_of(given);
    const std::string name = file_name(given);
    if (m.document.is_empty()) {
      m.notices.add(Severity::warning, name + " has nothing to lie under yet", {{Severity::warning, given, 0, {}, "there are no stems", "add inventories first"}});
      continue;
    }
    if (!kind) {
      m.notices.add(Severity::error, name + " cannot be laid under the stems", {{Severity::error, given, 0, {}, "it is neither an image nor a point cloud", "GeoTIFF, PNG, JPEG, LAS, PCD and PLY can be"}});
      continue;
    }
    remember_folder(m, given);
    ui::Underlay u;
    u.id = m.underlays.next_id();
    u.path = fs::absolute(given, code).lexically_normal().string();
    u.is_cloud = *kind == UnderlayKind::cloud;
    u.opacity = u.is_cloud ? 1.0f : 0.75f;
    u.frame = m.document.state().reference;
    m.view.layers.underlays = true;
    m.view.underlays.push_back(std::move(u));
  }
}

void remove_underlay(WindowModel& m, int id) {
  if (const auto job = m.underlays.job_of(id)) m.jobs.cancel(*job);
  std::erase_if(m.view.underlays, [id](const ui::Underlay& u) { return u.id == id; });
  m.underlays.forget(id);
  remember_underlays(m);
}

void restore_underlays(WindowModel& m) {
  m.view.underlays = m.underlay_memory.find(m.document.path());
  for (ui::Underlay& u : m.view.underlays) u.id = m.underlays.next_id();
}

void remember_underlays(WindowModel& m) {
  if (!m.document.path().empty()) m.underlay_memory.remember(m.document.path(), m.view.underlays);
}

void tend_underlays(WindowModel& m) {
  if (m.view.underlays.empty() || !m.document.is_derived()) return;
  const bool has_changed = std::exchange(m.underlays.tended_revision, m.document.revision()) != m.document.revision();
  std::vector<int> given_up;
  for (ui::Underlay& u : m.view.underlays) {
    if (was_given_up(m, u)) given_up.push_back(u.id);
    const bool is_stale = (has_changed || m.underlays.frame_of(u.id) != u.frame) && u.state != ui::Underlay::State::wanted && m.underlays.is_stale(u.id, request_of(m, u));
    if (u.state == ui::Underlay::State::wanted || is_stale) start_reading(m, u);
  }
  for (const int id : given_up) leave_unread(m, id, "Reading it was given up; it is read again when the project is opened again");
}

}  // namespace stemwise
