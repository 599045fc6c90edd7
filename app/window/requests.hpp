#pragma once
#include "app/align_job.hpp"
#include "app/window/project_io.hpp"
#include "app/window/window_model.hpp"
#include "ui/requests.hpp"

namespace stemwise {

/// Does what the person asked for: a command, a job, or a change of the view.
void answer(WindowModel& model, const ui::Request& request);

// By subject; one file each.
void run_action(WindowModel& model, ui::ActionId action);

// Trees and matches (review_requests.cpp).
/// `stem` none: the later stem of the match that is in doubt.
void select_tree(WindowModel& model, TreeId tree, bool fly, StemRef stem = {});
void click_stem(WindowModel& model, const render::Pick& pick);
void go_to_doubtful(WindowModel& model, bool forward);
void accept_selected(WindowModel& model);
void reject_selected(WindowModel& model);
void unlink_selected(WindowModel& model);
void start_tool(WindowModel& model, ui::Tool tool);
void split_selected(WindowModel& model);
/// Surveys that could not be aligned (rescue_requests.cpp): two clicks make a pair, two pairs are enough.
void pair_stem(WindowModel& model, StemRef stem);
void align_by_pairs(WindowModel& model);
void accept_pose_of(WindowModel& model, InventoryId inventory);  ///< the proposed one; aligns again with it
void forget_used_pairs(WindowModel& model);
/// The alignment, and the pairs that it was asked for with as links by hand: one change of the project.
void apply_with_named_pairs(WindowModel& model, AlignOutcome outcome);
// Polygons drawn by clicks (shape_requests.cpp): the lasso, and where a survey looked.
void start_shape(WindowModel& model, ui::Tool tool);
void finish_shape(WindowModel& model, const std::vector<Eigen::Vector3d>& corners_m, bool adds);
void estimate_coverage_again(WindowModel& model, InventoryId inventory);
/// Runs the tool in hand (link, swap, merge) on two stems; where that cannot be, a notice says why.
void use_tool(WindowModel& model, ui::Tool tool, StemRef from, StemRef to);
void set_selected_fate(WindowModel& model, std::optional<Fate> fate);

// Several trees at once (group_requests.cpp). One tree is no group: it is selected as by a click.
void select_group(WindowModel& model, std::vector<TreeId> trees);
void toggle_in_group(WindowModel& model, TreeId tree);
void accept_group(WindowModel& model);  ///< every automatic match of them, and fates that are in doubt
void reject_group(WindowModel& model);  ///< the match of each that is in doubt
void set_group_fate(WindowModel& model, std::optional<Fate> fate);
void toggle_queue_region(WindowModel& model);

// Surveys (survey_requests.cpp).
JobVerdict take_surveys(WindowModel& model, ReadSurveys read);
void add_demo(WindowModel& model);

// Import (import_requests.cpp).
/// Reads them; the import dialog opens where something was guessed or went wrong, or where it is asked for.
void add_inventories(WindowModel& model, const std::vector<std::string>& paths, bool ask = false);
void edit_import(WindowModel& model, const ui::request::ImportEdit& edit);
void finish_import(WindowModel& model, bool take_them);

// Underlays (underlay_requests.cpp).
/// Files that are neither image nor point cloud are named in a notice.
void add_underlays(WindowModel& model, const std::vector<std::string>& paths);
void remove_underlay(WindowModel& model, int id);
void restore_underlays(WindowModel& model);   ///< those of the open project's last time
void remember_underlays(WindowModel& model);  ///< for the next time; nothing for a project without a file
void tend_underlays(WindowModel& model);      ///< every frame: reads what is wanted, and again what the project has moved

// Files (file_requests.cpp).
void remember_folder(WindowModel& model, const std::string& path);  ///< where the next file dialog starts
void new_project(WindowModel& model);
void open_project(WindowModel& model, const std::string& path);
void save(WindowModel& model);
void save_as(WindowModel& model, const std::string& path);
void export_layer(WindowModel& model, const ui::request::Export& what);
void write_report(WindowModel& model, const ui::request::WriteReport& what);
JobVerdict tell_written(WindowModel& model, const std::string& path, const Result<Done>& written);
/// Another project in this window (take_up.cpp): nothing of the one before stays.
void take_up(WindowModel& model, ProjectState state, const std::string& path, ProjectStamp stamp, bool saved);

// Leaving (leave_requests.cpp).
/// Runs `next` at once, or after the person has decided about unsaved changes.
void leave_then(WindowModel& model, std::function<void()> next);
void answer_leave(WindowModel& model, bool save_first);
void quit(WindowModel& model);  ///< also from inside a dialog

// What a window that ended without a word has left (recovery_requests.cpp).
void offer_recovery(WindowModel& model, const std::string& of = {});  ///< `of`: only of the project in this file
void answer_recovery(WindowModel& model, ui::RecoveryAnswer answer);

// Rules, charts and sheets (result_requests.cpp).
void choose_rules(WindowModel& model, const std::optional<RulePack>& pack);
void read_own_rules(WindowModel& model, const std::string& path);
void write_field_check_sheet(WindowModel& model, const ui::request::WriteFieldCheck& what);
void save_chart(WindowModel& model, const ui::request::SaveChart& what);

// Questions and choices (questions.cpp).
void ask(WindowModel& model, ui::Question question, AnswerActions actions);
void answer_question(WindowModel& model, ui::Answer answer);
/// Runs `write` at once for a new file, after asking for another one. A Stemwise project is never written over: that is
/// refused with a notice.
void write_over(WindowModel& model, const std::string& path, std::function<void()> write);

// Alignment (align_requests.cpp).
void run_alignment(WindowModel& model);

}  // namespace stemwise
