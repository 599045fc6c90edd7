#pragma once
#include "ui/frame.hpp"
#include "ui/panels/placement_form_panel.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Step 4, right: which value a merged tree takes, by policy and by hand, and where the project lies on the earth.
class MergePanel {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_fusion(Widgets& w, Frame& frame);
  void draw_tree(Widgets& w, Frame& frame);
  void draw_source(Widgets& w, Frame& frame, const TreeRow& tree, FusedAttribute attribute, std::optional<InventoryId> chosen);

  PlacementFormPanel placement_;
  bool tree_open_ = false;
};

}  // namespace stemwise::ui
