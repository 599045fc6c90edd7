#include <algorithm>
#include <filesystem>

#include "app/window/project_io.hpp"
#include "app/window/requests.hpp"
#include "core/project/commands.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

std::int64_t count_of(std::size_t n) { return static_cast<std::int64_t>(n); }

/// One command for all of them.
void add_all(WindowModel& m, std::vector<Inventory> inventories) {
  const std::size_t count = inventories.size();
  std::vector<CommandPtr> commands;
  for (Inventory& inventory : inventories) commands.push_back(add_inventory(std::move(inventory)));
  m.execute(count == 1 ? std::move(commands.front()) : group("Add " + ui::plural(count_of(count), "inventory", "inventories"), std::move(commands)));
  m.view.selected_inventory = m.document.state().inventories.back()->id;
}

/// What could not be read at all, apart from what was read with remarks: nobody may miss it.
void tell_unread(WindowModel& m, const ReadSurveys& read) {
  Issues issues;
  std::string names;
  std::size_t count = 0;
  for (const ReadSurvey& survey : read) {
    if (survey.inventory) continue;
    ++count;
    names += (names.empty() ? "" : ", ") + file_name(survey.path);
    // What stopped it first, then the rows.
    Issues own = survey.inventory.issues;
    std::stable_sort(own.begin(), own.end(), [](const Issue& a, const Issue& b) { return a.severity > b.severity; });
    for (Issue& issue : own) {
      if (issue.file.empty()) issue.file = survey.path;
      issues.push_back(std::move(issue));
    }
  }
  if (count == 0) return;
  const std::string title = read.size() == 1 ? names + " could not be read"
                                             : std::to_string(count) + " of " + ui::plural(count_of(read.size()), "file", "files") + " could not be read: " + names;
  m.notices.add(Severity::error, title, std::move(issues));
}

}  // namespace

JobVerdict take_surveys(WindowModel& m, ReadSurveys read) {
  std::vector<Inventory> inventories;
  Issues remarks;
  std::size_t stems = 0;
  for (ReadSurvey& survey : read) {
    if (!survey.inventory) continue;
    remarks.insert(remarks.end(), survey.inventory.issues.begin(), survey.inventory.issues.end());
    stems += survey.inventory->stems.size();
    inventories.push_back(std::move(*survey.inventory));
  }
  const std::size_t count = inventories.size();
  m.notices.add_issues("Read " + ui::plural(count_of(count), "file", "files") + " with " + ui::plural(count_of(remarks.size()), "remark", "remarks"), remarks);
  tell_unread(m, read);
  if (inventories.empty()) return {false, "no usable row"};
  add_all(m, std::move(inventories));
  return {true, ui::plural(count_of(count), "inventory", "inventories") + " with " + ui::plural(count_of(stems), "stem", "stems")};
}

void add_demo(WindowModel& m) {
  m.jobs.start<ReadSurveys>(
      "Make the demo", JobLane::person, [](const Progress& progress) { return make_demo(progress); },
      [&m](ReadSurveys read) {
        new_project(m);
        const JobVerdict verdict = take_surveys(m, std::move(read));
        if (verdict.good) m.execute(set_title("Demo forest"));
        m.view.step = ui::Step::align;
        return verdict;
      });
}

}  // namespace stemwise
