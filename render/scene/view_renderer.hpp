#pragma once
#include <memory>
#include <string>

#include "render/ground.hpp"
#include "render/heat_map.hpp"
#include "render/picture.hpp"
#include "render/projection.hpp"
#include "render/scene_model.hpp"

namespace stemwise::render {

/// The half of the viewport that lives on the graphics card: layers, VTK's stage, the composed texture. Made on the first
/// frame and destroyed with the context current.
class ViewRenderer {
 public:
  ViewRenderer();
  ~ViewRenderer();

  /// The scene (or theme, or what is shown of it) is another: buffers are filled again when their view is next drawn.
  void forget_scene();
  void draw_scene(const SceneModel& scene, const Ground& ground, const HeatGrid& heat, const Projection& projection, const ViewOptions& options);
  void draw_overlay(const SceneModel& scene, const Projection& projection, const ViewOptions& options);
  /// Puts both together; the texture stays the same between calls while the size does.
  std::uint32_t compose(PixelSize size);
  std::uint32_t texture() const;
  Image read() const;
  std::string renderer_name() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace stemwise::render
