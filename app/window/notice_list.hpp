#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ui/window_status.hpp"

namespace stemwise {

/// A button of a notice.
struct NoticeChoice {
  std::string label;
  std::function<void()> run;  ///< empty: the notice is only put away
};

/// What the person was told, newest first.
class NoticeList {
 public:
  /// The same once more takes the place of the earlier one, and is new again.
  void add(Severity severity, std::string title, Issues details = {}, std::vector<NoticeChoice> choices = {});
  /// A notice from the issues of one piece of work; the worst of them gives the severity. Nothing without issues.
  void add_issues(const std::string& title, const Issues& issues);
  void dismiss(int id);
  void clear();
  /// Puts the notice away; what its button does.
  std::function<void()> choose(int id, std::size_t choice);
  void advance(double elapsed_s);
  const std::vector<ui::Notice>& all() const { return notices_; }

 private:
  std::vector<ui::Notice> notices_;
  std::map<int, std::vector<NoticeChoice>> choices_;  ///< of those notices that have any
  int next_id_ = 1;
};

}  // namespace stemwise
