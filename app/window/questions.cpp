#include <filesystem>

#include "app/window/requests.hpp"
#include "io/project_file.hpp"
#include "io/replace_file.hpp"
#include "io/same_file.hpp"

namespace stemwise {
namespace fs = std::filesystem;

void ask(WindowModel& m, ui::Question question, AnswerActions actions) {
  if (m.view.dialog != ui::Dialog::question) m.behind_question = m.view.dialog;
  m.status.question = std::move(question);
  m.on_answer = std::move(actions);
  m.view.dialog = ui::Dialog::question;
}

void answer_question(WindowModel& m, ui::Answer answer) {
  m.view.dialog = std::exchange(m.behind_question, ui::Dialog::none);
  m.status.question.reset();
  const AnswerActions actions = std::exchange(m.on_answer, {});
  const std::function<void()>& next = answer == ui::Answer::yes ? actions.yes : answer == ui::Answer::no ? actions.no : actions.other;
  if (next) next();
}

void write_over(WindowModel& m, const std::string& path, std::function<void()> write) {
  std::error_code error;
  const std::string name = fs::path(path).filename().string();
  const bool open_one = names_same_file(path, m.document.path());
  if (open_one || is_project(path)) {
    const std::string what = open_one ? " is the open project" : " is a Stemwise project";
    m.notices.add(Severity::error, name + what + ": nothing was written",
                  {Issue{Severity::error, path, 0, "", "an export or a report would destroy the project in this file", "Choose another file name."}});
    return;
  }
  if (const fs::path folder = fs::absolute(path, error).parent_path(); !fs::exists(folder, error)) {
    m.notices.add_issues(name + " could not be written", {cannot_write(path, "")});
    return;
  }
  if (!fs::exists(path, error)) {
    write();
    return;
  }
  ask(m, {"Replace " + name + "?", name + " is in " + fs::path(path).parent_path().string() + " already. Its content will be lost.", "Replace", "Keep the old one", ""},
      {.yes = std::move(write)});
}

}  // namespace stemwise
