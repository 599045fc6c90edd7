#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Step 4, right: which value a merged tree takes, and where the project lies on the earth.
class MergePanel {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_fusion(Widgets& w, Frame& frame);
  void draw_place(Widgets& w, Frame& frame);
  void draw_anchor(Widgets& w, Frame& frame);
  void draw_crs(Widgets& w, Frame& frame);
  void load(const Georeference& from);

  std::uint64_t loaded_ = ~0ULL;  ///< the project's revision that the form shows
  int kind_ = 0;
  Georeference form_;
};

}  // namespace stemwise::ui
