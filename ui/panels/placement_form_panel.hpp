#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Where the project lies on the earth: four ways to say it, and what would come of it, residuals included, before it is applied.
class PlacementFormPanel {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_ways(Widgets& w, Frame& frame);
  void draw_anchor(Widgets& w, Frame& frame);
  void draw_control(Widgets& w, Frame& frame);
  void draw_typed(Widgets& w, Frame& frame);
  void draw_gnss(Widgets& w, Frame& frame);
  void draw_crs(Widgets& w, Frame& frame);
  void draw_azimuth(Widgets& w, Frame& frame);
  void draw_geoid(Widgets& w, Frame& frame);
  void draw_file(Widgets& w, Frame& frame, const char* path, std::string& file, Dialog dialog, const char* columns);
  void draw_preview(Widgets& w, Frame& frame);
  void draw_residuals(Widgets& w, const Georeference& georeference);

  std::uint64_t loaded_ = ~0ULL;  ///< the project's revision whose georeference the form shows
  Georeference shown_;
  bool more_open_ = false;
  double latitude_deg_ = 0.0, longitude_deg_ = 0.0, height_m_ = 0.0;  ///< of the selected tree, being typed
};

}  // namespace stemwise::ui
