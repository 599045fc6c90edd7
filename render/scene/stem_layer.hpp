#pragma once
#include <span>

#include "render/gl/program.hpp"
#include "render/gl/quads.hpp"
#include "render/scene/layer.hpp"
#include "render/scene_model.hpp"

namespace stemwise::render {

/// The 3D view's stems: tilted cylinders at DBH scale. Each is one quad that turns towards the eye and is shaded round, and
/// one cut face at its top (left out while moving); at least about a pixel wide, so that no stem vanishes.
class StemLayer : public Layer {
 public:
  StemLayer();
  void fill(std::span<const Mark> marks);
  void draw(const FrameView& view) override;

 private:
  void set_uniforms(const FrameView& view) const;

  Program program_;
  Quads sides_;
  Quads tops_;
};

}  // namespace stemwise::render
