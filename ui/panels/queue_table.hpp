#pragma once
#include <vector>

#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Doubtful trees, most doubtful first, each with its reason in words.
class QueueTable {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void filter(const Frame& frame);
  void draw_filters(Widgets& w, Frame& frame);
  void draw_progress(Widgets& w, const Frame& frame);
  struct Key {
    std::uint64_t revision = ~0ULL;
    QueueFilter filter;
    std::optional<Fate> fate;
    TreeId selected;  ///< stays in the list when it is decided, until another one is looked at
    bool operator==(const Key&) const = default;
  };
  Key key_;
  QueueProgress progress_;
  std::vector<std::size_t> rows_;  ///< into tables.queue
  TreeId shown_tree_;
};

}  // namespace stemwise::ui
