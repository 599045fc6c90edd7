#pragma once
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// A dialog in the middle of the window. `open` becomes false by Escape or the cross.
class Modal {
 public:
  enum class Place { middle, top };  ///< top: its upper edge stays where it is while the height changes
  Modal(Widgets& w, const char* title, float width_at_100_percent, float height_at_100_percent, bool& open, Place place = Place::middle);
  ~Modal();
  Modal(const Modal&) = delete;
  Modal& operator=(const Modal&) = delete;
  explicit operator bool() const { return visible_; }

 private:
  bool visible_ = false;
};

}  // namespace stemwise::ui
