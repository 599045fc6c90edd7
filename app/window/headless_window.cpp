#include "app/window/headless_window.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <nlohmann/json.hpp>

#include "app/window/retained_frame.hpp"
#include "app/window/window_model.hpp"
#include "render/surfaceless_context.hpp"

namespace stemwise {
namespace {

constexpr float frame_s = 1.0f / 60.0f;
constexpr int most_settling_frames = 20000;

/// Dear ImGui 1.86 names keys by the backend's numbers: GLFW's, so that actions mean the same keys here.
void map_keys(ImGuiIO& io) {
  const std::pair<ImGuiKey, int> keys[] = {{ImGuiKey_Tab, 258}, {ImGuiKey_LeftArrow, 263}, {ImGuiKey_RightArrow, 262}, {ImGuiKey_UpArrow, 265},
                                           {ImGuiKey_DownArrow, 264}, {ImGuiKey_Home, 268}, {ImGuiKey_End, 269}, {ImGuiKey_Delete, 261},
                                           {ImGuiKey_Backspace, 259}, {ImGuiKey_Space, 32}, {ImGuiKey_Enter, 257}, {ImGuiKey_Escape, 256},
                                           {ImGuiKey_A, 'A'}, {ImGuiKey_C, 'C'}, {ImGuiKey_V, 'V'}, {ImGuiKey_X, 'X'}, {ImGuiKey_Y, 'Y'}, {ImGuiKey_Z, 'Z'}};
  for (const auto& [key, code] : keys) io.KeyMap[key] = code;
}

}  // namespace

struct HeadlessWindow::Parts {
  std::unique_ptr<render::SurfacelessContext> context;
  ImGuiContext* imgui = nullptr;
  std::unique_ptr<RetainedFrame> picture;
  std::unique_ptr<Desk> desk;
  int width = 0, height = 0;
  float scale = 1.0f;

  ~Parts() {
    desk.reset();
    if (imgui != nullptr) {
      ImGui_ImplOpenGL3_Shutdown();
      ImGui::DestroyContext(imgui);
    }
    picture.reset();
  }
};

Result<std::unique_ptr<HeadlessWindow>> HeadlessWindow::create(const HeadlessOptions& options) {
  auto context = render::SurfacelessContext::create();
  if (!context) return Result<std::unique_ptr<HeadlessWindow>>::failure(context.issues);
  std::unique_ptr<HeadlessWindow> window(new HeadlessWindow());
  window->parts_ = std::make_unique<Parts>();
  Parts& p = *window->parts_;
  p.context = std::move(*context);
  p.width = options.width;
  p.height = options.height;
  p.scale = options.scale;
  p.imgui = ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  io.MousePos = {-1000, -1000};
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  map_keys(io);
  ImGui_ImplOpenGL3_Init("#version 150");
  p.picture = std::make_unique<RetainedFrame>();
  p.desk = std::make_unique<Desk>(options.desk);
  window->frames(3);
  return window;
}

HeadlessWindow::~HeadlessWindow() = default;
Desk& HeadlessWindow::desk() { return *parts_->desk; }

void HeadlessWindow::frame() {
  Parts& p = *parts_;
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(p.width), static_cast<float>(p.height)};
  io.DeltaTime = frame_s;
  if (p.desk->prepare(p.scale)) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    p.picture->forget();
  }
  ImGui_ImplOpenGL3_NewFrame();
  if (io.Fonts->TexID == nullptr) ImGui_ImplOpenGL3_CreateFontsTexture();
  p.desk->take_keys();
  ImGui::NewFrame();
  p.desk->frame(frame_s);
  ImGui::Render();
  p.picture->draw(*ImGui::GetDrawData(), p.width, p.height, p.desk->live_textures());
}

void HeadlessWindow::frames(int count) {
  for (int i = 0; i < count; ++i) frame();
}

void HeadlessWindow::settle() {
  WindowModel& m = parts_->desk->model();
  for (int i = 0; i < most_settling_frames; ++i) {
    frame();
    if (parts_->desk->is_settled()) break;
    if (m.jobs.is_busy()) m.jobs.wait_for_news();
  }
  frames(2);
}

bool HeadlessWindow::has(const std::string& path) {
  const ui::WidgetEntry* entry = parts_->desk->registry().find(path);
  return entry != nullptr && entry->visible && entry->enabled;
}

std::string HeadlessWindow::value(const std::string& path) {
  const ui::WidgetEntry* entry = parts_->desk->registry().find(path);
  return entry != nullptr ? entry->value : "";
}

void HeadlessWindow::move_to(float x, float y) {
  ImGui::GetIO().MousePos = {x, y};
  frame();
}

void HeadlessWindow::click_at(float x, float y) {
  move_to(x, y);
  frame();
  ImGui::GetIO().MouseDown[0] = true;
  frame();
  ImGui::GetIO().MouseDown[0] = false;
  frame();
  frames(2);
}

bool HeadlessWindow::click(const std::string& path) {
  if (!has(path)) return false;
  const ui::Rect rect = parts_->desk->registry().find(path)->rect;  // a copy: the registry is made anew every frame
  click_at(rect.center_x(), rect.center_y());
  return true;
}

bool HeadlessWindow::double_click(const std::string& path) {
  if (!has(path)) return false;
  const ui::Rect rect = parts_->desk->registry().find(path)->rect;
  move_to(rect.center_x(), rect.center_y());
  for (int i = 0; i < 2; ++i) {
    ImGui::GetIO().MouseDown[0] = true;
    frame();
    ImGui::GetIO().MouseDown[0] = false;
    frame();
  }
  frames(2);
  return true;
}

void HeadlessWindow::drag(float x0, float y0, float x1, float y1, int button) {
  move_to(x0, y0);
  ImGui::GetIO().MouseDown[button] = true;
  frame();
  for (int i = 1; i <= 6; ++i) {
    const float t = static_cast<float>(i) / 6.0f;
    move_to(x0 + (x1 - x0) * t, y0 + (y1 - y0) * t);
  }
  ImGui::GetIO().MouseDown[button] = false;
  frames(3);
}

void HeadlessWindow::wheel(float notches) {
  ImGui::GetIO().MouseWheel = notches;
  frame();
  ImGui::GetIO().MouseWheel = 0.0f;
  frames(2);
}

void HeadlessWindow::hold_ctrl(bool held) { ImGui::GetIO().KeyCtrl = held; }

void HeadlessWindow::hold_shift(bool held) { ImGui::GetIO().KeyShift = held; }

void HeadlessWindow::press(ui::KeyChord chord) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyCtrl = chord.ctrl;
  io.KeyShift = chord.shift;
  io.KeyAlt = chord.alt;
  if (chord == ui::action(ui::ActionId::help_keys).chord) io.AddInputCharacter('?');
  io.KeysDown[static_cast<int>(chord.key)] = true;
  frame();
  io.KeysDown[static_cast<int>(chord.key)] = false;
  io.KeyCtrl = io.KeyShift = io.KeyAlt = false;
  frames(2);
}

void HeadlessWindow::press(ui::ActionId id) { press(ui::action(id).chord); }

void HeadlessWindow::type(const std::string& text) {
  ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
  frames(2);
}

bool HeadlessWindow::fill(const std::string& path, const std::string& text) {
  if (!click(path)) return false;
  press({ui::key('A'), true});
  if (text.empty()) {
    press({static_cast<ui::Key>(261)});  // Delete
  } else {
    type(text);
  }
  press({static_cast<ui::Key>(258)});  // Tab
  return true;
}

Result<Done> HeadlessWindow::screenshot(const std::string& path) { return render::write_png(parts_->picture->read(), path); }

void HeadlessWindow::resize(int width, int height) {
  parts_->width = width;
  parts_->height = height;
  frames(4);
}

void HeadlessWindow::draw_anew() { parts_->picture->forget(); }
double HeadlessWindow::drawn_share() const { return parts_->picture->drawn_share(); }

std::string registry_json(const ui::WidgetRegistry& registry) {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [path, entry] : registry.entries()) {
    json[path] = {{"x", entry.rect.x}, {"y", entry.rect.y}, {"width", entry.rect.width}, {"height", entry.rect.height},
                  {"visible", entry.visible}, {"enabled", entry.enabled}, {"value", entry.value}};
  }
  return json.dump(1);
}

}  // namespace stemwise
