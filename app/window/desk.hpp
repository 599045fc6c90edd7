#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/window/frame_damage.hpp"
#include "ui/widgets/registry.hpp"

namespace stemwise {

struct WindowModel;

struct DeskOptions {
  std::vector<std::string> paths;   ///< a project, or inventories
  std::string config_folder;        ///< empty: nothing is remembered or recovered
};

/// The whole window but for the window itself: runs in any GL context and ImGui context, on a display or without one.
class Desk {
 public:
  explicit Desk(const DeskOptions& options);
  ~Desk();  ///< with the GL context current
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  /// Before ImGui::NewFrame. True when ImGui's font texture has to be made anew.
  bool prepare(float display_scale);
  void take_keys();  ///< right before ImGui::NewFrame, with the frame's input in place
  /// Between ImGui::NewFrame and ImGui::Render. Changes framebuffer bindings and the GL viewport.
  void frame(double elapsed_s);
  /// Seconds until something moves by itself; the window may sleep so long.
  double seconds_to_next_frame() const;
  /// No job runs, the tables are of the current revision, autosave has its copy, and nothing moves but what blinks.
  bool is_settled() const;

  void drop(const std::vector<std::string>& paths);  ///< files dropped on the window
  void ask_to_close();
  bool wants_close() const;
  void keep_unsaved_work();  ///< the process has to end now: the last change is in the autosave when this returns
  void remember(int width, int height, bool maximised);  ///< writes the preferences

  WindowModel& model() { return *model_; }
  const WindowModel& model() const { return *model_; }
  const ui::WidgetRegistry& registry() const;
  const std::string& focused() const;  ///< the control that has the keyboard; "" for none
  std::string title() const;
  /// The map or 3D view and the charts, as the last frame showed them.
  std::vector<LiveTexture> live_textures() const;

 private:
  struct Parts;
  void poll(double elapsed_s);
  void start_deriving();
  void refresh_status();
  void draw();
  void open_given(const std::vector<std::string>& paths);

  std::unique_ptr<WindowModel> model_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stemwise
