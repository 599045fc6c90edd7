#include "app/window/review_walk.hpp"

namespace stemwise {

bool ReviewWalk::Place::is_before(const Place& other) const {
  if (doubt != other.doubt) return doubt > other.doubt;
  if (about_fate != other.about_fate) return other.about_fate;
  return tree < other.tree;
}

void ReviewWalk::stand_on(const QueueRow& row, bool anew) {
  if (anew) visited_.clear();
  place_ = place_of(row);
  visited_.insert(row.tree);
}

std::optional<std::size_t> ReviewWalk::next(const std::vector<QueueRow>& queue) {
  std::optional<std::size_t> from_top;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (queue[i].decided) continue;
    if (!from_top) from_top = i;
    if (!place_ || (place_->is_before(place_of(queue[i])) && !visited_.contains(queue[i].tree))) return i;
  }
  visited_.clear();
  return from_top;
}

std::optional<std::size_t> ReviewWalk::previous(const std::vector<QueueRow>& queue) const {
  std::optional<std::size_t> from_bottom;
  for (std::size_t i = queue.size(); i-- > 0;) {
    if (queue[i].decided) continue;
    if (!from_bottom) from_bottom = i;
    if (place_ && place_of(queue[i]).is_before(*place_)) return i;
  }
  return from_bottom;
}

}  // namespace stemwise
