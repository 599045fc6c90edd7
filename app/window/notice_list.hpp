#pragma once
#include <string>
#include <vector>

#include "ui/window_status.hpp"

namespace stemwise {

/// What the person was told, newest first.
class NoticeList {
 public:
  void add(Severity severity, std::string title, Issues details = {});
  /// A notice from the issues of one piece of work; the worst of them gives the severity. Nothing without issues.
  void add_issues(const std::string& title, const Issues& issues);
  void dismiss(int id);
  void clear() { notices_.clear(); }
  void advance(double elapsed_s);
  const std::vector<ui::Notice>& all() const { return notices_; }

 private:
  std::vector<ui::Notice> notices_;
  int next_id_ = 1;
};

}  // namespace stemwise
