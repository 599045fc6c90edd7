#include "app/window/notice_list.hpp"

#include <algorithm>

namespace stemwise {
namespace {

constexpr std::size_t most_notices = 200;

}  // namespace

void NoticeList::add(Severity severity, std::string title, Issues details, std::vector<NoticeChoice> choices) {
  const auto same = std::find_if(notices_.begin(), notices_.end(), [&](const ui::Notice& n) { return n.severity == severity && n.title == title && n.details == details; });
  if (same != notices_.end()) dismiss(same->id);
  ui::Notice notice{next_id_++, severity, std::move(title), std::move(details), 0.0, {}};
  for (const NoticeChoice& choice : choices) notice.choices.push_back(choice.label);
  if (!choices.empty()) choices_[notice.id] = std::move(choices);
  notices_.insert(notices_.begin(), std::move(notice));
  if (notices_.size() > most_notices) notices_.resize(most_notices);
}

void NoticeList::add_issues(const std::string& title, const Issues& issues) {
  if (issues.empty()) return;
  Severity worst = Severity::note;
  for (const Issue& issue : issues) worst = std::max(worst, issue.severity);
  add(worst, title, issues);
}

void NoticeList::dismiss(int id) {
  std::erase_if(notices_, [&](const ui::Notice& notice) { return notice.id == id; });
  choices_.erase(id);
}

void NoticeList::clear() {
  notices_.clear();
  choices_.clear();
}

std::function<void()> NoticeList::choose(int id, std::size_t choice) {
  const auto it = choices_.find(id);
  if (it == choices_.end() || choice >= it->second.size()) return {};
  std::function<void()> run = std::move(it->second[choice].run);
  dismiss(id);
  return run;
}

void NoticeList::advance(double elapsed_s) {
  for (ui::Notice& notice : notices_) notice.age_s += elapsed_s;
}

}  // namespace stemwise
