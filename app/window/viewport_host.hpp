#pragma once
#include <Eigen/Core>
#include <optional>

#include "app/window/document.hpp"
#include "app/window/drawn_shape.hpp"
#include "app/window/frame_damage.hpp"
#include "render/viewport.hpp"
#include "ui/requests.hpp"
#include "ui/view_state.hpp"
#include "ui/window_status.hpp"

namespace stemwise {

/// Brings the project and what the person looks at to the VTK viewport, and the mouse to its camera and picking.
class ViewportHost {
 public:
  /// Mirrors project and view; cheap when nothing changed.
  void update(const Document& document, const ui::ViewState& view, std::vector<render::ShownUnderlay> underlays, double now_s);
  /// Needs the GL context. An empty picture for an empty rectangle.
  ui::ViewportPicture render(const ui::Rect& rect, double scale);
  /// Steps flights and blinking; true while something moves and the window has to be drawn again.
  bool advance(double elapsed_s, const ui::ViewState& view);

  /// What a click hit; the camera is moved here.
  std::optional<render::Pick> pointer(const ui::request::Pointer& pointer, const ui::ViewState& view);
  void fly_to(TreeId tree, bool animated) { viewport_.fly_to(tree, animated); }
  /// The trees in a rectangle that was just drawn by Shift and a drag, or with the tool for it; once.
  std::optional<std::vector<TreeId>> take_selection() { return std::exchange(drawn_selection_, std::nullopt); }
  /// What the map shows, in the reference's frame; nothing before the first frame.
  std::optional<ui::MapRegion> map_region() const;
  DrawnShape& shape() { return shape_; }
  void fit() { viewport_.fit(); }
  void forget_measure() { measured_.clear(); }

  /// Fills hover card, cursor coordinates, measuring and legend.
  void describe(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const;
  const std::vector<LiveTexture>& live_textures() const { return live_; }  ///< of the pictures that render() gave
  std::string renderer_name() const { return renderer_; }
  const render::Viewport& viewport() const { return viewport_; }

 private:
  const render::Viewport& picture_at(double x_px, const ui::ViewState& view) const;
  struct Comparison;
  static std::optional<Comparison> comparison_of(const Document& document, const ui::ViewState& view);
  void update_later(const Document& document, render::ViewOptions options, const std::optional<Comparison>& comparison);
  void describe_hover(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const;
  void describe_click(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const;
  void move_camera(const ui::request::Pointer& pointer, bool space);
  void draw_box(const ui::request::Pointer& pointer);
  void describe_cursor(const Document& document, ui::WindowStatus& status) const;
  void describe_shapes(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const;
  void describe_measure(const Document& document, const ui::ViewState& view, ui::WindowStatus& status) const;

  render::Viewport viewport_;
  std::optional<render::Viewport> later_;  ///< only while two surveys are compared by sliding
  std::string earlier_name_, later_name_;
  TreeId hovered_;
  StemRef hovered_stem_;
  std::optional<ui::Rect> box_;  ///< from where the button went down to the cursor; sizes may be negative
  std::optional<std::vector<TreeId>> drawn_selection_;
  ui::Rect shown_;               ///< the picture, in pixels
  std::optional<Eigen::Vector2d> cursor_px_;
  DrawnShape shape_;
  std::vector<Eigen::Vector3d> measured_;  ///< 0, 1 or 2 points in the reference's frame
  std::vector<LiveTexture> live_;
  bool dragging_ = false;
  std::string renderer_;
};

}  // namespace stemwise
