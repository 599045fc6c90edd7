#include "app/window/run_window.hpp"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <utility>

#include "app/exit_code.hpp"
#include "app/platform/folders.hpp"
#include "app/window/desk.hpp"
#include "app/window/headless_window.hpp"
#include "app/window/input_queue.hpp"
#include "app/window/layout_key.hpp"
#include "app/window/retained_frame.hpp"
#include "app/window/window_model.hpp"
#include "app/window/window_script.hpp"
#include "ui/actions/keys.hpp"

namespace stemwise {
namespace {

void say_glfw_error(int code, const char* text) { std::cerr << "window: " << text << " (" << code << ")\n"; }

constexpr int least_width = 1024, least_height = 600;  ///< below that panels would lie over each other

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
    if (handle_ != nullptr) glfwSetWindowSizeLimits(handle_, std::min(width, least_width), std::min(height, least_height), GLFW_DONT_CARE, GLFW_DONT_CARE);
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

/// What the window's callbacks reach.
struct WindowEvents {
  Desk& desk;
  InputQueue input;
  bool is_uncovered = false;           ///< the display wants the picture again
  double mouse_x = 0.0, mouse_y = 0.0;  ///< where it was last seen, window px
  std::array<bool, 5> buttons{};        ///< held as the frames know it
  std::atomic<bool> has_news = false;   ///< a job has something to show; set on its thread
};

WindowEvents& events_of(GLFWwindow* window) { return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window)); }

using Kind = InputEvent::Kind;

void on_key(GLFWwindow* window, int key, int scancode, int action, int) {
  const int meant = layout_key(key, glfwGetKeyName(key, scancode));
  if (action != GLFW_REPEAT) events_of(window).input.add({.kind = Kind::key, .code = meant, .down = action == GLFW_PRESS, .scancode = scancode});
}

void on_character(GLFWwindow* window, unsigned int character) { events_of(window).input.add({.kind = Kind::character, .code = static_cast<int>(character)}); }

void on_button(GLFWwindow* window, int button, int action, int) {
  WindowEvents& events = events_of(window);
  events.input.add({.kind = Kind::button, .code = button, .down = action == GLFW_PRESS, .x = events.mouse_x, .y = events.mouse_y});
}

void on_move(GLFWwindow* window, double x, double y) {
  events_of(window).mouse_x = x;
  events_of(window).mouse_y = y;
  events_of(window).input.add({.kind = Kind::move, .x = x, .y = y});
}

void on_wheel(GLFWwindow* window, double x, double y) { events_of(window).input.add({.kind = Kind::wheel, .x = x, .y = y}); }

void on_drop(GLFWwindow* window, int count, const char** paths) {
  events_of(window).desk.drop({paths, paths + count});
}

void on_refresh(GLFWwindow* window) { events_of(window).is_uncovered = true; }

void on_close(GLFWwindow* window) {
  glfwSetWindowShouldClose(window, GLFW_FALSE);
  events_of(window).desk.ask_to_close();
}

/// In the place of the callbacks of ImGui's backend, but for focus and the mouse coming and going.
void listen(GLFWwindow* window, WindowEvents& events) {
  glfwSetWindowUserPointer(window, &events);
  glfwGetCursorPos(window, &events.mouse_x, &events.mouse_y);
  glfwSetKeyCallback(window, on_key);
  glfwSetCharCallback(window, on_character);
  glfwSetMouseButtonCallback(window, on_button);
  glfwSetCursorPosCallback(window, on_move);
  glfwSetScrollCallback(window, on_wheel);
  glfwSetDropCallback(window, on_drop);
  glfwSetWindowRefreshCallback(window, on_refresh);
  glfwSetWindowCloseCallback(window, on_close);
}

/// Keys, letters and the wheel go to ImGui's backend; buttons are held here, because the backend would ask for how they are now.
void hand_over(GLFWwindow* window, WindowEvents& events, const InputEvent& event) {
  switch (event.kind) {
    case Kind::key: ImGui_ImplGlfw_KeyCallback(window, event.code, event.scancode, event.down ? GLFW_PRESS : GLFW_RELEASE, 0); break;
    case Kind::character: ImGui_ImplGlfw_CharCallback(window, static_cast<unsigned int>(event.code)); break;
    case Kind::button:
      if (event.code >= 0 && event.code < static_cast<int>(events.buttons.size())) events.buttons[static_cast<std::size_t>(event.code)] = event.down;
      break;
    case Kind::wheel: ImGui_ImplGlfw_ScrollCallback(window, event.x, event.y); break;
    case Kind::move: break;
  }
}

/// Begins ImGui's frame with what it may know of what a person did.
void start_frame(GLFWwindow* window, WindowEvents& events) {
  ImGuiIO& io = ImGui::GetIO();
  ImVec2 mouse = io.MousePos;
  bool mouse_told = false;
  for (const InputEvent& event : events.input.take(ui::is_typing())) {
    hand_over(window, events, event);
    if (event.kind != Kind::move && event.kind != Kind::button) continue;
    mouse = {static_cast<float>(event.x), static_cast<float>(event.y)};
    mouse_told = true;
  }
  ImGui_ImplGlfw_NewFrame();  // sets the mouse to where it is now: too early while things wait that were done before
  if (mouse_told || !events.input.is_empty()) io.MousePos = mouse;
  std::copy(events.buttons.begin(), events.buttons.end(), io.MouseDown);
  events.desk.take_keys();
  ImGui::NewFrame();
}

void draw_frame(const GlfwWindow& window, WindowEvents& events, RetainedFrame& picture, double elapsed_s) {
  Desk& desk = events.desk;
  const bool is_uncovered = std::exchange(events.is_uncovered, false);
  if (desk.prepare(window.content_scale())) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    picture.forget();
  }
  ImGui_ImplOpenGL3_NewFrame();
  if (ImGui::GetIO().Fonts->TexID == nullptr) ImGui_ImplOpenGL3_CreateFontsTexture();
  start_frame(window.handle(), events);
  desk.frame(elapsed_s);
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window.handle(), &width, &height);
  if (!picture.draw(*ImGui::GetDrawData(), width, height, desk.live_textures()) && !is_uncovered) return;
  picture.present();
  glfwSwapBuffers(window.handle());
}

/// The widgets, and what a script has to wait for: how many keys and buttons were dealt with, and whether all came to rest.
void write_registry(const std::string& path, const WindowEvents& events, bool at_rest, std::string& written) {
  ui::WidgetRegistry registry = events.desk.registry();
  registry.record("window/inputs", {.value = std::to_string(events.input.count())});
  registry.record("window/settled", {.value = at_rest && events.input.is_empty() && events.desk.is_settled() ? "yes" : "no"});
  std::string now = registry_json(registry);
  if (now == written) return;
  {
    std::ofstream file(path + ".new");
    file << now << "\n";
  }
  std::error_code error;
  std::filesystem::rename(path + ".new", path, error);
  written = std::move(now);
}

/// Until an event, for `wait_s` at most, or until the process was asked to end. True after an event. GLFW does not say why
/// it came back: in time it was an event of whatever kind; on a machine that kept the process waiting only what is known of.
bool wait_for_event(WindowEvents& events, double wait_s, const std::atomic<bool>& interrupted) {
  constexpr double slice_s = 0.25;
  for (; wait_s > 0.0 && !interrupted; wait_s -= slice_s) {
    const double slice = std::min(wait_s, slice_s), before = glfwGetTime();
    glfwWaitEventsTimeout(slice);
    const bool known = events.has_news.exchange(false) || events.is_uncovered || !events.input.is_empty();
    if (known || glfwGetTime() - before < slice * 0.98) return true;
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
    const bool event = wait_for_event(events, wait, interrupted);
    if (interrupted) break;
    frames_after_event = event || !events.input.is_empty() ? 3 : std::max(0, frames_after_event - 1);
    const double now = glfwGetTime();
    draw_frame(window, events, picture, now - last);
    last = now;
    if (desk.title() != title) glfwSetWindowTitle(window.handle(), (title = desk.title()).c_str());
    if (!options.ui_json.empty()) write_registry(options.ui_json, events, frames_after_event == 0, registry);
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
  WindowEvents events{.desk = desk, .input = {}, .is_uncovered = true};
  desk.model().jobs.on_news([&events] {
    events.has_news = true;
    glfwPostEmptyEvent();
  });
  listen(window.handle(), events);
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
