#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Where the surveys do not agree on a merged tree: every value, and which one was kept.
class ConflictTable {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void filter(const Frame& frame);

  std::uint64_t revision_ = ~0ULL;
  std::string text_, filtered_by_;
  std::vector<std::size_t> rows_;  ///< into Derived::conflicts
};

}  // namespace stemwise::ui
