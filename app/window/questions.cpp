#include <filesystem>

#include "app/window/requests.hpp"
#include "io/project_file.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code error;
  return fs::equivalent(a, b, error) || fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

}  // namespace

void ask(WindowModel& m, ui::Question question, std::function<void()> yes, std::function<void()> no) {
  m.status.question = std::move(question);
  m.on_yes = std::move(yes);
  m.on_no = std::move(no);
  m.view.dialog = ui::Dialog::question;
}

void answer_question(WindowModel& m, bool yes) {
  m.view.dialog = ui::Dialog::none;
  m.status.question.reset();
  const std::function<void()> next = yes ? std::exchange(m.on_yes, nullptr) : std::exchange(m.on_no, nullptr);
  m.on_yes = m.on_no = nullptr;
  if (next) next();
}

void write_over(WindowModel& m, const std::string& path, std::function<void()> write) {
  std::error_code error;
  const std::string name = fs::path(path).filename().string();
  const bool open_one = is_same_file(path, m.document.path());
  if (open_one || is_project(path)) {
    const std::string what = open_one ? " is the open project" : " is a Stemwise project";
    m.notices.add(Severity::error, name + what + ": nothing was written",
                  {Issue{Severity::error, path, 0, "", "an export or a report would destroy the project in this file", "Choose another file name."}});
    return;
  }
  if (!fs::exists(path, error)) {
    write();
    return;
  }
  ask(m, {"Replace " + name + "?", name + " is in " + fs::path(path).parent_path().string() + " already. Its content will be lost.", "Replace", "Keep the old one"},
      std::move(write));
}

}  // namespace stemwise
