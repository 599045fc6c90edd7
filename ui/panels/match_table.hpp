#pragma once
#include <vector>

#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// All matches: sorted and filtered by the person; ten thousands of rows without lag.
class MatchTable {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void arrange(const Frame& frame);
  struct Key {
    std::uint64_t revision = ~0ULL;
    std::string text;
    std::optional<Fate> fate;
    std::size_t column = 9;
    bool ascending = true;
    bool operator==(const Key&) const = default;
  };
  Key key_;
  Key wanted_;
  std::vector<std::size_t> rows_;  ///< into tables.matches, in the order shown
  TreeId shown_tree_;
};

}  // namespace stemwise::ui
