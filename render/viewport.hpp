#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/project/project_state.hpp"
#include "core/survey/tables.hpp"
#include "render/color_by.hpp"
#include "render/picture.hpp"
#include "render/view_options.hpp"

namespace stemwise::render {

/// What lies under the cursor. `tree` is none for a stem that is in no tree yet.
struct Pick {
  TreeId tree;
  StemRef stem;
  double distance_px = 0.0;  ///< from the cursor to the mark, 0 on it
};

/// A place in the world. `inventory` names the frame: the reference, or an unaligned survey that is shown beside it.
struct WorldPosition {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  InventoryId inventory;
};

/// The map and the 3D view of one project in one framebuffer texture. Pixels are those of the picture (framebuffer
/// pixels, origin top left, y down). Everything but render() and image() works without a GL context and before the
/// first frame, once resize() or render() has told the size.
class Viewport {
 public:
  Viewport();
  ~Viewport();  ///< with the same context current as in render()
  Viewport(Viewport&&) noexcept;
  Viewport& operator=(Viewport&&) noexcept;

  /// Every frame: set_options(), sync(), render(). Mirrors the project by the options; cheap when neither `revision` nor
  /// the options changed, and nothing of the arguments is kept. The first sync with stems, and one that adds, removes or
  /// places an inventory, fits the view.
  void sync(const ProjectState& state, const Tables& tables, std::uint64_t revision);
  void set_options(const ViewOptions& options);  ///< cheap when equal
  const ViewOptions& options() const;

  /// Draws where something changed since the last call, and returns the GL texture (bottom row first: show it with
  /// uv (0,1)-(1,0)). `scale` is the window's content scale: text and lines grow with it. Leaves framebuffer 0 bound.
  /// Throws std::runtime_error when GL cannot be used.
  std::uint32_t render(PixelSize size, double scale);
  /// Looks from where the other one does: for two pictures that are shown side by side.
  void follow(const Viewport& other);
  std::uint64_t pictures_drawn() const;  ///< goes up whenever render() draws
  bool is_dirty() const;  ///< render() would draw; nothing to do otherwise
  /// The last picture, top row first, 4 bytes a pixel. Needs the context.
  Image image();
  std::string renderer_name() const;  ///< GL_RENDERER after the first frame

  // Camera. Positions in pixels of the picture; deltas as the mouse moved.
  void resize(PixelSize size, double scale);
  void fit();                                              ///< everything shown
  void pan(double dx_px, double dy_px);
  void zoom_at(double x_px, double y_px, double factor);   ///< factor > 1 comes nearer; the point under the cursor stays
  void orbit(double dx_px, double dy_px);                  ///< 3D; on the map it does nothing
  void fly_to(TreeId tree, bool animated);                 ///< F, N: centred, near enough to see its neighbours
  void fly_to(const Eigen::Vector3d& in_reference_m, double radius_m, bool animated);
  /// Every frame: steps a flight (120 ms) and the moment of less detail after a turn of the wheel; true while either is
  /// under way.
  bool advance(double elapsed_s);
  double metres_per_px() const;                            ///< on the map, or at the centre of the 3D view

  // Questions; all on the CPU.
  std::optional<Pick> pick(double x_px, double y_px, double tolerance_px = 4.0) const;
  std::vector<TreeId> trees_in_rectangle(double x0_px, double y0_px, double x1_px, double y1_px) const;
  std::vector<TreeId> trees_in_polygon(std::span<const Eigen::Vector2d> corners_px) const;  ///< a lasso
  std::optional<WorldPosition> world_at(double x_px, double y_px) const;
  std::optional<Eigen::Vector2d> pixels_of(TreeId tree) const;  ///< nothing when it is not in the picture
  std::optional<Eigen::Vector2d> pixels_of(StemRef stem) const;
  Eigen::Vector2d pixels_of(const Eigen::Vector3d& in_reference_m) const;
  const Legend& legend() const;
  int shown_marks() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace stemwise::render
