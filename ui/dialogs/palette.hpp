#pragma once
#include <string>
#include <vector>

#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Finds any action by its words, or a tree by its number; Enter runs it.
class Palette {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  struct Hit {
    std::optional<ActionId> action;
    TreeId tree;
  };
  std::vector<Hit> hits(const Frame& frame) const;
  void run(Frame& frame, const Hit& hit);
  void draw_hit(Widgets& w, Frame& frame, const Hit& hit, std::size_t place);

  std::string query_;
  std::size_t at_ = 0;
  std::size_t shown_ = 1;  ///< hits of the last frame: the dialog is as high as they need
  bool fresh_ = true;
};

}  // namespace stemwise::ui
