#pragma once
#include <span>

#include "render/gl/program.hpp"
#include "render/gl/quads.hpp"
#include "render/scene/layer.hpp"
#include "render/scene_model.hpp"

namespace stemwise::render {

/// The map's circles: soft fill, outline, and the shapes of the fates, smooth at every size.
class DiscLayer : public Layer {
 public:
  DiscLayer();
  void fill(std::span<const Mark> marks);
  void draw(const FrameView& view) override;

 private:
  Program program_;
  Quads quads_;
};

}  // namespace stemwise::render
