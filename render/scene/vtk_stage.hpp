#pragma once
#include <memory>
#include <string>
#include <vector>

#include "render/scene/layer.hpp"
#include "render/view_camera.hpp"

class vtkPolyData;

namespace stemwise::render {

/// VTK's render window, renderer and camera over somebody else's current GL context, drawing into a framebuffer texture.
/// Surfaces (ground, coverage) are VTK actors; the large sets are layers, drawn after them in VTK's own pass.
class VtkStage {
 public:
  VtkStage();
  ~VtkStage();
  VtkStage(const VtkStage&) = delete;
  VtkStage& operator=(const VtkStage&) = delete;

  void look_down(const MapCamera& camera, PixelSize size);
  void look(const OrbitCamera& camera, PixelSize size, double scene_radius_m);
  void clear_surfaces();
  /// `is_lit`: shaded by its normals (ground); else plain colour in the order of adding (coverage); colours at
  /// the points go before `colour`.
  void add_surface(vtkPolyData* surface, Rgba colour, bool is_lit);
  void set_layers(std::vector<Layer*> layers);
  /// Draws and returns VTK's texture of `size`. `view`'s matrix is filled from VTK's camera.
  unsigned int render(PixelSize size, FrameView view, Rgba background);
  std::string renderer_name() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace stemwise::render
