#pragma once
#include <vector>

#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Every decision by hand, newest first, with time, author, before, after and note.
class EditLogTab {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  std::string filter_;
  std::string filtered_by_;
  std::uint64_t revision_ = ~0ULL;
  std::vector<std::size_t> rows_;
};

}  // namespace stemwise::ui
