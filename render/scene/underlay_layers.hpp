#pragma once
#include <memory>
#include <vector>

#include "render/ground.hpp"
#include "render/scene/cloud_layer.hpp"
#include "render/scene/raster_layer.hpp"
#include "render/scene_model.hpp"
#include "render/view_options.hpp"

namespace stemwise::render {

/// The layers of all underlays that are shown, kept as long as these are the same.
class UnderlayLayers {
 public:
  void forget_scene();  ///< stems or ground are others: everything is placed again
  /// Makes, places and lets go of layers so that they fit what is shown. Cheap when nothing changed.
  void sync(const ViewOptions& options, const SceneModel& scene, const Ground& ground);
  std::vector<Layer*> layers();  ///< pictures first, then clouds

 private:
  struct Entry {
    ShownUnderlay shown;
    std::unique_ptr<RasterLayer> raster;
    std::unique_ptr<CloudLayer> cloud;
    bool is_placed = false;
    bool is_map = false;  ///< placed for the map
  };
  static Entry make(const ShownUnderlay& shown);
  static void place(Entry& entry, const SceneModel& scene, const Ground& ground, const ViewOptions& options);

  /// The ground guessed from the stems is no wall for a cloud that has its own.
  class GroundForgetter : public Layer {
   public:
    void draw(const FrameView& view) override;
  };

  std::vector<Entry> entries_;
  GroundForgetter ground_forgetter_;
};

/// How far the cloud's ground lies from that of the stems, as the median, where that is more than 2 m: another datum of
/// heights. 0 else.
double height_shift_m(const CloudUnderlay& cloud, const SceneModel& scene, const Ground& ground);

}  // namespace stemwise::render
