#pragma once
#include "ui/panels/conflict_table.hpp"
#include "ui/panels/edit_log_tab.hpp"
#include "ui/panels/growth_tab.hpp"
#include "ui/panels/jobs_tab.hpp"
#include "ui/panels/match_table.hpp"
#include "ui/panels/queue_table.hpp"

namespace stemwise::ui {

/// The tabs below the viewport: review queue, matches, growth, conflicts, edit log, jobs.
class BottomPanel {
 public:
  void draw(Widgets& w, Frame& frame, const Rect& rect);

 private:
  void draw_tabs(Widgets& w, Frame& frame, const Rect& rect);
  static void draw_tab(Widgets& w, Frame& frame, BottomTab tab, const char* label, const std::string& count, float x, float y);

  QueueTable queue_;
  MatchTable matches_;
  GrowthTab growth_;
  ConflictTable conflicts_;
  EditLogTab log_;
  JobsTab jobs_;
};

}  // namespace stemwise::ui
