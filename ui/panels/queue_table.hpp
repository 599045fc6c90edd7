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
  struct Key {
    std::uint64_t revision = ~0ULL;
    std::string text;
    bool open_only = true;
    std::optional<Fate> fate;
    bool operator==(const Key&) const = default;
  };
  Key key_;
  Key wanted_;
  std::vector<std::size_t> rows_;  ///< into tables.queue
  TreeId shown_tree_;
};

}  // namespace stemwise::ui
