#include "app/window/desk.hpp"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "app/platform/folders.hpp"
#include "app/window/autosave.hpp"
#include "app/window/file_watch.hpp"
#include "app/window/requests.hpp"
#include "app/window/window_model.hpp"
#include "io/project_file.hpp"
#include "ui/actions/availability.hpp"
#include "ui/shell.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

std::string preferences_file(const std::string& folder) { return folder + "/window.json"; }

void apply_preferences(const Preferences& p, ui::ViewState& view) {
  view.theme = p.theme;
  view.reduce_motion = p.reduce_motion;
  view.goes_on = p.goes_on;
  view.zoom_percent = p.zoom_percent;
  view.panels = p.panels;
  view.layers = p.layers;
}

/// Where the project's file lies, else its first survey's; "" when neither is in a file.
std::string project_folder(const Document& document) {
  std::string file = document.path();
  for (const auto& inventory : document.state().inventories) {
    if (file.empty()) file = inventory->source.path;
  }
  std::error_code error;
  const std::filesystem::path folder = file.empty() ? std::filesystem::path() : std::filesystem::absolute(file, error).lexically_normal().parent_path();
  return std::filesystem::is_directory(folder, error) ? folder.string() : "";
}

/// The panels can be used where they have so much room at 100 %; a smaller window is never zoomed out below that.
double most_zoom_percent(float width, float height) {
  constexpr double least_width = 940.0, least_height = 530.0, step = 10.0;
  if (width <= 0.0f || height <= 0.0f) return 200.0;  // not known before the first frame
  const double fits = std::min(width / least_width, height / least_height) * 100.0;
  return std::clamp(std::floor(fits / step) * step, 100.0, 200.0);
}

}  // namespace

struct Desk::Parts {
  ui::Shell shell;
  std::unique_ptr<Autosave> autosave;
  FileWatch watch;
  std::vector<std::string> recent_kept;  ///< of the preferences' file: a window that dies does not forget what was open
  std::string config_folder;
  double now_s = 0.0;
  bool moving = false;
  int frames_to_close = 0;  ///< asked to: a text field is left and its text answered first
  int busy_frames = 3;  ///< frames to draw after news: ImGui needs two to settle
};

Desk::Desk(const DeskOptions& options) : model_(std::make_unique<WindowModel>()), parts_(std::make_unique<Parts>()) {
  parts_->config_folder = options.config_folder;
  WindowModel& m = *model_;
  if (!options.config_folder.empty()) {
    m.preferences = read_preferences(preferences_file(options.config_folder));
    parts_->recent_kept = m.preferences.recent_projects;
    m.autosave_folder = options.config_folder + "/autosave";
    parts_->autosave = std::make_unique<Autosave>(m.autosave_folder);
    m.autosave_file = parts_->autosave->file();
    m.underlay_memory = UnderlayMemory::read(options.config_folder + "/underlays.json");
    m.import_memory = ImportMemory::read(options.config_folder + "/imports.json");
    apply_preferences(m.preferences, m.view);
  }
  m.status.home_folder = platform::home_folder();
  m.status.version = STEMWISE_VERSION;
  if (options.paths.empty()) {
    offer_recovery(m);
  } else {
    open_given(options.paths);
  }
}

Desk::~Desk() {
  model_->jobs.cancel_all();
  if (!parts_->autosave || (model_->document.is_dirty() && !model_->wants_close)) return;
  while (model_->jobs.is_busy()) {
    model_->jobs.wait_for_news();
    model_->jobs.poll();
  }
  parts_->autosave->forget(*model_);
}

void Desk::open_given(const std::vector<std::string>& paths) {
  if (paths.size() == 1 && is_project(paths.front())) {
    open_project(*model_, paths.front());
  } else {
    add_inventories(*model_, paths);
  }
}

bool Desk::prepare(float display_scale) {
  model_->status.most_zoom_percent = most_zoom_percent(ImGui::GetIO().DisplaySize.x / display_scale, ImGui::GetIO().DisplaySize.y / display_scale);
  const auto zoom = static_cast<float>(std::min(model_->view.zoom_percent, model_->status.most_zoom_percent) / 100.0);
  model_->scale = display_scale * zoom;
  return parts_->shell.prepare(model_->view, model_->scale);
}

void Desk::take_keys() { parts_->shell.take_keys(); }

void Desk::frame(double elapsed_s) {
  parts_->now_s += elapsed_s;
  poll(elapsed_s);
  start_deriving();
  WindowModel& m = *model_;
  m.previews.tend(m);
  m.viewport.update(m.document, m.view, m.underlays.shown(m.view), parts_->now_s);
  parts_->moving = m.viewport.advance(elapsed_s, m.view);
  m.status.viewport = m.viewport.render(parts_->shell.viewport_rect(), model_->scale);
  refresh_status();
  draw();
  if (parts_->frames_to_close > 0 && --parts_->frames_to_close == 0) quit(m);
}

void Desk::poll(double elapsed_s) {
  WindowModel& m = *model_;
  m.notices.advance(elapsed_s);
  if (m.jobs.poll()) parts_->busy_frames = 3;
  if (parts_->autosave) parts_->autosave->tend(m);
  parts_->watch.tend(m, elapsed_s);
  if (!parts_->config_folder.empty() && parts_->recent_kept != m.preferences.recent_projects) {
    parts_->recent_kept = m.preferences.recent_projects;
    write_preferences(preferences_file(parts_->config_folder), m.preferences);
  }
  tend_underlays(m);
}

void Desk::start_deriving() {
  WindowModel& m = *model_;
  if (m.document.is_derived() || m.jobs.is_busy(JobLane::tables)) return;
  using Shared = std::shared_ptr<const ui::Derived>;
  m.jobs.start<Shared>(
      "Tables", JobLane::tables,
      [state = m.document.snapshot(), revision = m.document.revision()](const Progress&) { return std::make_shared<const ui::Derived>(ui::derive(*state, revision)); },
      [&m](Shared derived) {
        Shared old = m.document.shared_derived();
        m.document.take(std::move(derived));
        // Letting go of a hundred thousand rows takes as long as a frame: somewhere else.
        m.jobs.start<int>("Tables of before", JobLane::tables, [old = std::move(old)](const Progress&) { return 0; }, [](int) { return JobVerdict{}; });
        return JobVerdict{};
      });
}

void Desk::refresh_status() {
  WindowModel& m = *model_;
  ui::WindowStatus& s = m.status;
  s.project_title = m.document.is_empty() ? "" : m.document.title();
  s.saved_text = m.document.is_empty() ? "" : m.document.is_dirty() ? "not saved" : "saved";
  if (!m.document.is_dirty() && m.saved_at) {
    s.saved_text = "saved " + ui::ago_text(std::chrono::duration<double>(std::chrono::steady_clock::now() - *m.saved_at).count());
  }
  if (is_changed_elsewhere(m)) s.saved_text = m.document.is_dirty() ? "not saved, changed elsewhere" : "changed elsewhere";
  s.recent_projects = m.preferences.recent_projects;
  s.jobs = m.jobs.views();
  s.notices = m.notices.all();
  s.working_folder = m.preferences.working_folder.empty() ? s.home_folder : m.preferences.working_folder;
  s.project_folder = project_folder(m.document);
  if (s.project_folder.empty()) s.project_folder = s.working_folder;
  s.places.clear();
  if (s.project_folder != m.preferences.working_folder) s.places.push_back(s.project_folder);
  if (!m.preferences.working_folder.empty()) s.places.push_back(m.preferences.working_folder);
  s.charts = m.charts.views();
  m.viewport.describe(m.document, m.view, s);
}

void Desk::draw() {
  WindowModel& m = *model_;
  const ui::Availabilities available = ui::availabilities(m.document.project(), m.document.derived(), m.view, m.status);
  ui::Requests requests;
  ui::Frame frame{m.document.project(), m.document.revision(), m.document.derived(), m.status, available, m.view, requests};
  parts_->shell.draw(frame);
  for (const ui::Request& request : requests.take()) {
    const bool every_frame = std::holds_alternative<ui::request::Pointer>(request) || std::holds_alternative<ui::request::ShowChart>(request);
    if (!every_frame) parts_->busy_frames = 3;
    answer(m, request);
  }
  if (m.charts.take_news()) parts_->busy_frames = 2;
  parts_->busy_frames = std::max(0, parts_->busy_frames - 1);
}

double Desk::seconds_to_next_frame() const {
  if (parts_->busy_frames > 0 || parts_->frames_to_close > 0 || parts_->moving) return 0.0;
  if (parts_->shell.viewport_rect().width > 0 && model_->viewport.viewport().is_dirty()) return 0.0;
  if (!model_->notices.all().empty() && model_->notices.all().front().age_s < 10.0) return 0.5;
  if (model_->jobs.is_busy()) return 0.2;
  return 10.0;
}

bool Desk::is_settled() const {
  const WindowModel& m = *model_;
  return !m.jobs.is_busy() && m.document.is_derived() && (m.view.blink || seconds_to_next_frame() > 0.0);
}

void Desk::drop(const std::vector<std::string>& dropped) {
  std::vector<std::string> paths = dropped, underlays;
  const auto first = std::stable_partition(paths.begin(), paths.end(), [](const std::string& path) { return !is_underlay(path); });
  underlays.assign(first, paths.end());
  paths.erase(first, paths.end());
  if (!underlays.empty()) add_underlays(*model_, underlays);
  if (paths.empty()) return;
  if (paths.size() == 1 && is_project(paths.front()) && model_->document.is_empty()) {
    open_project(*model_, paths.front());
  } else {
    add_inventories(*model_, paths);
  }
}

void Desk::ask_to_close() {
  parts_->shell.leave_field();  // what is being typed counts as said
  parts_->frames_to_close = 2;
}

void Desk::keep_unsaved_work() {
  WindowModel& m = *model_;
  if (!parts_->autosave) return;
  while (m.jobs.is_busy(JobLane::keeper)) {
    m.jobs.wait_for_news();
    m.jobs.poll();
  }
  parts_->autosave->tend(m);
  while (m.jobs.is_busy(JobLane::keeper)) {
    m.jobs.wait_for_news();
    m.jobs.poll();
  }
}

bool Desk::wants_close() const { return model_->wants_close; }

void Desk::remember(int width, int height, bool maximised) {
  if (parts_->config_folder.empty()) return;
  Preferences& p = model_->preferences;
  if (!maximised) {
    p.width = width;
    p.height = height;
  }
  p.maximised = maximised;
  p.theme = model_->view.theme;
  p.reduce_motion = model_->view.reduce_motion;
  p.goes_on = model_->view.goes_on;
  p.zoom_percent = model_->view.zoom_percent;
  p.panels = model_->view.panels;
  p.layers = model_->view.layers;
  remember_underlays(*model_);
  write_preferences(preferences_file(parts_->config_folder), p);
}

const ui::WidgetRegistry& Desk::registry() const { return parts_->shell.registry(); }

std::vector<LiveTexture> Desk::live_textures() const {
  std::vector<LiveTexture> live = model_->viewport.live_textures();
  for (const ui::ChartView& view : model_->charts.views()) live.push_back({view.texture, model_->charts.pictures_painted(), view.width_px, view.height_px, false});
  if (const auto [texture, version] = model_->previews.page_texture(); texture != 0) live.push_back({texture, version});
  return live;
}

const std::string& Desk::focused() const { return parts_->shell.focused(); }

std::string Desk::title() const {
  if (model_->document.is_empty()) return "Stemwise";
  return model_->document.title() + (model_->document.is_dirty() ? " (not saved)" : "") + " · Stemwise";
}

}  // namespace stemwise
