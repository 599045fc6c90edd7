#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The named packs of rules for growth that nobody believes, each with what it would flag before it is chosen.
class RulesForm {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_pack(Widgets& w, Frame& frame, const RulePreview* preview, const std::string& name, const std::string& title);
  void draw_counts(Widgets& w, const RulePreview& preview);
};

}  // namespace stemwise::ui
