#pragma once
#include <memory>
#include <string>

#include "app/window/desk.hpp"
#include "core/base/result.hpp"
#include "ui/actions/action.hpp"

namespace stemwise {

struct HeadlessOptions {
  DeskOptions desk;
  int width = 1600;
  int height = 1000;
  float scale = 1.0f;
};

/// The window without a display, driven like a person would: one change of mouse or keys per frame, frames of equal
/// length, no clock. Widgets are found by their path in the registry. For tests, screenshots and the guide.
class HeadlessWindow {
 public:
  /// An issue where no GL context can be made.
  static Result<std::unique_ptr<HeadlessWindow>> create(const HeadlessOptions& options);
  ~HeadlessWindow();
  HeadlessWindow(const HeadlessWindow&) = delete;
  HeadlessWindow& operator=(const HeadlessWindow&) = delete;

  Desk& desk();
  void frame();
  void frames(int count);
  /// Until no job runs, tables are of the current revision and nothing moves by itself.
  void settle();

  bool has(const std::string& path);      ///< drawn and enabled in the last frame
  std::string value(const std::string& path);
  /// False when the widget is not there or greyed out.
  bool click(const std::string& path);
  bool double_click(const std::string& path);
  void click_at(float x, float y);
  void move_to(float x, float y);
  void drag(float x0, float y0, float x1, float y1, int button = 0);
  void wheel(float notches);
  void hold_ctrl(bool held);              ///< while clicking
  void hold_shift(bool held);             ///< while dragging
  void press(ui::KeyChord chord);
  void press(ui::ActionId action);        ///< by its key
  void type(const std::string& text);     ///< UTF-8, into the focused field
  /// Clicks a field, replaces what is in it, leaves it with Tab.
  bool fill(const std::string& path, const std::string& text);
  Result<Done> screenshot(const std::string& path);
  void resize(int width, int height);
  void draw_anew();                       ///< everything in the next frame, also what did not change
  double drawn_share() const;             ///< of the window in the last frame, 0..1

 private:
  HeadlessWindow() = default;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// All widgets of the last frame as JSON, by path: rect, visible, enabled, value. For scripts that drive the real window.
std::string registry_json(const ui::WidgetRegistry& registry);

}  // namespace stemwise
