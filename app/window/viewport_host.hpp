#pragma once
#include <Eigen/Core>
#include <optional>

#include "app/window/document.hpp"
#include "render/viewport.hpp"
#include "ui/requests.hpp"
#include "ui/view_state.hpp"
#include "ui/window_status.hpp"

namespace stemwise {

/// Brings the project and what the person looks at to the VTK viewport, and the mouse to its camera and picking.
class ViewportHost {
 public:
  /// Mirrors project and view; cheap when nothing changed.
  void update(const Document& document, const ui::ViewState& view, double now_s);
  /// Needs the GL context. An empty picture for an empty rectangle.
  ui::ViewportPicture render(const ui::Rect& rect, double scale);
  /// Steps flights and blinking; true while something moves and the window has to be drawn again.
  bool advance(double elapsed_s, const ui::ViewState& view);

  /// What a click hit; the camera is moved here.
  std::optional<render::Pick> pointer(const ui::request::Pointer& pointer, const ui::ViewState& view);
  void fly_to(TreeId tree, bool animated) { viewport_.fly_to(tree, animated); }
  void fit() { viewport_.fit(); }
  void forget_measure() { measured_.clear(); }

  /// Fills hover card, cursor coordinates, measuring and legend.
  void describe(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const;
  std::string renderer_name() const { return renderer_; }
  const render::Viewport& viewport() const { return viewport_; }

 private:
  void describe_hover(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const;
  void describe_cursor(const Document& document, ui::WindowStatus& status) const;
  void describe_measure(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const;

  render::Viewport viewport_;
  TreeId hovered_;
  std::optional<Eigen::Vector2d> cursor_px_;
  std::vector<Eigen::Vector3d> measured_;  ///< 0, 1 or 2 points in the reference's frame
  bool dragging_ = false;
  std::string renderer_;
};

}  // namespace stemwise
