#pragma once
#include <map>
#include <string>

#include "ui/geometry.hpp"

namespace stemwise::ui {

/// What one widget looked like in the last frame: what tests, screen readers and scripts know of the window.
struct WidgetEntry {
  Rect rect;
  bool visible = false;
  bool enabled = true;
  std::string value;  ///< text, number or state as shown; a button's is its label
};

/// Every widget of the frame by its path ("review/accept").
class WidgetRegistry {
 public:
  void begin_frame() { entries_.clear(); }
  void record(const std::string& path, WidgetEntry entry) { entries_[path] = std::move(entry); }
  const WidgetEntry* find(const std::string& path) const {
    const auto it = entries_.find(path);
    return it == entries_.end() ? nullptr : &it->second;
  }
  const std::map<std::string, WidgetEntry>& entries() const { return entries_; }

 private:
  std::map<std::string, WidgetEntry> entries_;
};

}  // namespace stemwise::ui
