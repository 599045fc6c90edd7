#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "app/window/chart_host.hpp"
#include "app/window/document.hpp"
#include "app/window/job_runner.hpp"
#include "app/window/notice_list.hpp"
#include "app/window/pending_import.hpp"
#include "app/window/preferences.hpp"
#include "app/window/previews.hpp"
#include "app/window/review_walk.hpp"
#include "app/window/underlay_host.hpp"
#include "app/window/underlay_memory.hpp"
#include "app/window/viewport_host.hpp"
#include "ui/actions/action.hpp"
#include "ui/view_state.hpp"
#include "ui/window_status.hpp"

namespace stemwise {

/// Everything the window holds; the handlers of requests change it, the panels read it.
struct WindowModel {
  Document document;
  ui::ViewState view;
  ui::WindowStatus status;
  Preferences preferences;
  NoticeList notices;
  ViewportHost viewport;
  ChartHost charts;
  UnderlayHost underlays;
  UnderlayMemory underlay_memory;
  Previews previews;
  std::vector<PendingImport> imports;              ///< in the import dialog, in the order of status.imports
  ImportMemory import_memory;
  ReviewWalk walk;                                 ///< through the queue, by N and P
  float scale = 1.0f;                              ///< of the interface just now
  std::function<void()> after_leaving;             ///< what waits until changes are saved or given up
  std::function<void()> on_yes, on_no;             ///< of the question that is asked
  bool leaves_after_saving = false;
  std::optional<std::chrono::steady_clock::time_point> saved_at;
  std::string autosave_folder;
  std::string recovered_file;                      ///< what the recovery dialog is about
  bool wants_close = false;
  JobRunner jobs;  ///< last: its threads end before anything else goes

  void execute(CommandPtr command) { document.execute(std::move(command)); }
};

/// Author and time of a decision made now (SOURCE_DATE_EPOCH fixes the time).
EditStamp stamp_now(std::string note = {});

}  // namespace stemwise
