#include "app/window/run_window.hpp"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <utility>

#include "app/exit_code.hpp"
#include "app/platform/folders.hpp"
#include "app/window/desk.hpp"
#include "app/window/headless_window.hpp"
#include "app/window/layout_key.hpp"
#include "app/window/retained_frame.hpp"
#include "app/window/window_model.hpp"
#include "app/window/window_script.hpp"

namespace stemwise {
namespace {

void say_glfw_error(int code, const char* text) { std::cerr << "window: " << text << " (" << code << ")\n"; }

/// GLFW and its window; Dear ImGui on top. Ends in reverse.
class GlfwWindow {
 public:
  GlfwWindow(int width, int height, bool maximised) {
    glfwSetErrorCallback(say_glfw_error);
    if (!glfwInit()) return;
    fit_to_screen(width, height);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);  // without FORWARD_COMPAT: VTK draws wide lines
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_MAXIMIZED, maximised ? GLFW_TRUE : GLFW_FALSE);
    handle_ = glfwCreateWindow(width, height, "Stemwise", nullptr, nullptr);
    if (handle_ == nullptr) return;
    glfwSetWindowSizeLimits(handle_, 1024, 640, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwMakeContextCurrent(handle_);
    glfwSwapInterval(1);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplGlfw_InitForOpenGL(handle_, true);
    ImGui_ImplOpenGL3_Init("#version 150");
  }
  ~GlfwWindow() {
    if (handle_ != nullptr) {
      ImGui_ImplOpenGL3_Shutdown();
      ImGui_ImplGlfw_Shutdown();
      ImGui::DestroyContext();
      glfwDestroyWindow(handle_);
    }
    glfwTerminate();
  }
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;
  GLFWwindow* handle() const { return handle_; }
  float content_scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(handle_, &x, &y);
    return std::clamp(std::max(x, y), 1.0f, 3.0f);
  }

 private:
  static void fit_to_screen(int& width, int& height) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return;
    int x = 0, y = 0, most_wide = 0, most_high = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &most_wide, &most_high);
    if (most_wide > 0) width = std::min(width, most_wide);
    if (most_high > 0) height = std::min(height, most_high);
  }

  GLFWwindow* handle_ = nullptr;
};

/// Dear ImGui 1.86 looks at keys once a frame: one struck and let go between two frames would never have been down. So
/// letting go waits for the frame after.
class KeyQueue {
 public:
  void add(int key, int scancode, int action, int mods) { waiting_.push_back({key, scancode, action, mods}); }
  bool is_empty() const { return waiting_.empty(); }
  void deliver(GLFWwindow* window) {
    std::set<int> struck;
    while (!waiting_.empty()) {
      const Event event = waiting_.front();
      if (event.action == GLFW_RELEASE && struck.contains(event.key)) return;
      if (event.action == GLFW_PRESS) struck.insert(event.key);
      ImGui_ImplGlfw_KeyCallback(window, event.key, event.scancode, event.action, event.mods);
      waiting_.pop_front();
    }
  }

 private:
  struct Event {
    int key, scancode, action, mods;
  };
  std::deque<Event> waiting_;
};

/// What the window's callbacks reach.
struct WindowEvents {
  Desk& desk;
  KeyQueue keys;
  bool is_uncovered = false;  ///< the display wants the picture again
};

WindowEvents& events_of(GLFWwindow* window) { return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window)); }

void on_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
  events_of(window).keys.add(layout_key(key, glfwGetKeyName(key, scancode)), scancode, action, mods);
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
  events_of(window).desk.drop({paths, paths + count});
}

void on_refresh(GLFWwindow* window) { events_of(window).is_uncovered = true; }

void on_close(GLFWwindow* window) {
  glfwSetWindowShouldClose(window, GLFW_FALSE);
  events_of(window).desk.ask_to_close();
}

void draw_frame(const GlfwWindow& window, Desk& desk, RetainedFrame& picture, bool is_uncovered, double elapsed_s) {
  if (desk.prepare(window.content_scale())) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    picture.forget();
  }
  ImGui_ImplOpenGL3_NewFrame();
  if (ImGui::GetIO().Fonts->TexID == nullptr) ImGui_ImplOpenGL3_CreateFontsTexture();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  desk.frame(elapsed_s);
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window.handle(), &width, &height);
  if (!picture.draw(*ImGui::GetDrawData(), width, height, desk.live_textures()) && !is_uncovered) return;
  picture.present();
  glfwSwapBuffers(window.handle());
}

void write_registry(const std::string& path, const Desk& desk, std::string& written) {
  std::string now = registry_json(desk.registry());
  if (now == written) return;
  {
    std::ofstream file(path + ".new");
    file << now << "\n";
  }
  std::error_code error;
  std::filesystem::rename(path + ".new", path, error);
  written = std::move(now);
}

/// Until an event, for `wait_s` at most, or until the process was asked to end. True after an event.
bool wait_for_event(double wait_s, const std::atomic<bool>& interrupted) {
  constexpr double slice_s = 0.25;
  for (; wait_s > 0.0 && !interrupted; wait_s -= slice_s) {
    const double slice = std::min(wait_s, slice_s), before = glfwGetTime();
    glfwWaitEventsTimeout(slice);
    if (glfwGetTime() - before < slice * 0.98) return true;
  }
  return false;
}

void loop(const GlfwWindow& window, WindowEvents& events, const WindowOptions& options, const std::atomic<bool>& interrupted) {
  Desk& desk = events.desk;
  RetainedFrame picture;
  double last = glfwGetTime();
  int frames_after_event = 3;
  std::string registry, title;
  while (!desk.wants_close() && !interrupted) {
    // Sleeps while nothing happens: an idle window costs nothing.
    const double wait = frames_after_event > 0 ? 0.0 : desk.seconds_to_next_frame();
    if (wait <= 0.0) glfwPollEvents();
    const bool event = wait_for_event(wait, interrupted);
    if (interrupted) break;
    frames_after_event = event || !events.keys.is_empty() ? 3 : std::max(0, frames_after_event - 1);
    events.keys.deliver(window.handle());
    const double now = glfwGetTime();
    draw_frame(window, desk, picture, std::exchange(events.is_uncovered, false), now - last);
    last = now;
    if (desk.title() != title) glfwSetWindowTitle(window.handle(), (title = desk.title()).c_str());
    if (!options.ui_json.empty()) write_registry(options.ui_json, desk, registry);
  }
}

int run_on_display(const WindowOptions& options, const std::atomic<bool>& interrupted) {
  const std::string config = platform::config_folder();
  const Preferences remembered = read_preferences(config + "/window.json");
  const GlfwWindow window(options.width > 0 ? options.width : remembered.width, options.height > 0 ? options.height : remembered.height,
                          options.width == 0 && remembered.maximised);
  if (window.handle() == nullptr) {
    std::cerr << "error: no window can be opened: is there a display? Everything can be done without one, see stemwise --help\n";
    return 1;
  }
  Desk desk({options.paths, config});
  desk.model().jobs.on_news([] { glfwPostEmptyEvent(); });
  WindowEvents events{desk, {}, true};
  glfwSetWindowUserPointer(window.handle(), &events);
  glfwSetKeyCallback(window.handle(), on_key);  // in the place of ImGui's, which it calls
  glfwSetDropCallback(window.handle(), on_drop);
  glfwSetWindowRefreshCallback(window.handle(), on_refresh);
  glfwSetWindowCloseCallback(window.handle(), on_close);
  loop(window, events, options, interrupted);
  if (interrupted) desk.keep_unsaved_work();
  int width = 0, height = 0;
  glfwGetWindowSize(window.handle(), &width, &height);
  desk.remember(width, height, glfwGetWindowAttrib(window.handle(), GLFW_MAXIMIZED) == GLFW_TRUE);
  desk.model().jobs.on_news(nullptr);
  return interrupted ? static_cast<int>(ExitCode::interrupted) : 0;
}

}  // namespace

int run_window(const WindowOptions& options, const std::atomic<bool>& interrupted) {
  return options.script.empty() ? run_on_display(options, interrupted) : run_window_script(options);
}

}  // namespace stemwise
