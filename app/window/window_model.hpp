#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "app/window/autosave.hpp"
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

/// What the answers to a question do; empty: nothing.
struct AnswerActions {
  std::function<void()> yes = {}, no = {}, other = {};
};

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
  AnswerActions on_answer;                         ///< of the question that is asked
  ui::Dialog behind_question = ui::Dialog::none;   ///< goes on when that is answered
  bool leaves_after_saving = false;
  std::optional<std::chrono::steady_clock::time_point> saved_at;
  std::optional<ProjectStamp> changed_elsewhere;   ///< the document's stamp when its file was seen to hold something else
  std::string autosave_folder;                     ///< empty: nothing is kept or recovered
  std::string autosave_file;                       ///< this window's own
  std::optional<Leftover> leftover;                ///< what the recovery dialog is about
  std::optional<Leftover> rescued;                 ///< brought back; stays until this window has kept it itself
  bool wants_close = false;
  JobRunner jobs;  ///< last: its threads end before anything else goes

  void execute(CommandPtr command) { document.execute(std::move(command)); }
};

/// Author and time of a decision made now (SOURCE_DATE_EPOCH fixes the time).
EditStamp stamp_now(std::string note = {});

}  // namespace stemwise
