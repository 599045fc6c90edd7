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

/// A unit of diameters that was guessed from the values: worth a question.
struct GuessedUnit {
  InventoryId inventory;
  std::string path;
  std::string column;  ///< our name of it: dbh, circumference
  std::string unit;
  Issue issue;
};

std::optional<GuessedUnit> guess_in(const Issue& issue) {
  const std::string said = "unit guessed: ";
  if (!issue.text.starts_with(said)) return std::nullopt;
  for (const char* column : {"dbh", "circumference"}) {
    if (issue.help.find(std::string("--unit ") + column + "=") == std::string::npos) continue;
    const std::string unit = issue.text.substr(said.size(), issue.text.find(' ', said.size()) - said.size());
    return GuessedUnit{{}, "", column, unit, issue};
  }
  return std::nullopt;
}

/// What the next inventory is called by the project once this one is gone.
InventoryId id_after_removing(const ProjectState& state, InventoryId gone) {
  std::int64_t last = 0;
  for (const auto& inventory : state.inventories) {
    if (inventory->id != gone) last = std::max(last, inventory->id.value);
  }
  return {last + 1};
}

/// The same survey read once more takes the place of the first reading.
JobVerdict take_again(WindowModel& m, const GuessedUnit& guess, const std::string& unit, Result<Inventory> read) {
  const ProjectState& state = m.document.state();
  const Inventory* before = state.find(guess.inventory);
  if (before == nullptr) return {false, "the inventory is not in the project any more"};
  if (!read) {
    m.notices.add_issues(file_name(guess.path) + " could not be read again", read.issues);
    return {false, "not readable"};
  }
  read->name = before->name;
  const bool was_reference = state.reference == guess.inventory;
  std::vector<CommandPtr> commands;
  commands.push_back(remove_inventory(guess.inventory));
  commands.push_back(add_inventory(std::move(*read)));
  if (was_reference && state.inventories.size() > 1) commands.push_back(set_reference(id_after_removing(state, guess.inventory)));
  m.execute(group("Read " + before->name + " with its " + guess.column + " in " + unit, std::move(commands)));
  m.view.selected_inventory = m.document.state().inventories.back()->id;
  return {true, "read with the " + guess.column + " in " + unit};
}

void read_again(WindowModel& m, const GuessedUnit& guess, const std::string& unit) {
  m.jobs.start<Result<Inventory>>(
      "Read " + file_name(guess.path) + " again", JobLane::person,
      [guess, unit](const Progress& progress) { return read_survey_in_unit(guess.path, guess.column, unit, progress); },
      [&m, guess, unit](Result<Inventory> read) { return take_again(m, guess, unit, std::move(read)); });
}

void ask_for_unit(WindowModel& m, const GuessedUnit& guess) {
  const std::string what = guess.column == "dbh" ? "DBH" : guess.column;
  std::vector<NoticeChoice> choices{{"Yes, " + guess.unit, {}}};
  for (const std::string unit : {"cm", "in", "mm", "m"}) {
    if (guess.unit == unit) continue;
    choices.push_back({"No, " + (unit == "in" ? "inch" : unit), [&m, guess, unit] { read_again(m, guess, unit); }});
  }
  Issue issue = guess.issue;
  issue.help = "The file will be read again with the unit that you choose";
  m.notices.add(Severity::warning, file_name(guess.path) + ": is the " + what + " in " + guess.unit + "?", {std::move(issue)}, std::move(choices));
}

/// One command for all of them; their ids in the order given.
std::vector<InventoryId> add_all(WindowModel& m, std::vector<Inventory> inventories) {
  const std::size_t count = inventories.size();
  std::vector<CommandPtr> commands;
  for (Inventory& inventory : inventories) commands.push_back(add_inventory(std::move(inventory)));
  m.execute(count == 1 ? std::move(commands.front()) : group("Add " + ui::plural(count_of(count), "inventory", "inventories"), std::move(commands)));
  std::vector<InventoryId> ids;
  const auto& all = m.document.state().inventories;
  for (std::size_t i = all.size() - count; i < all.size(); ++i) ids.push_back(all[i]->id);
  m.view.selected_inventory = ids.back();
  return ids;
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

JobVerdict take_surveys(WindowModel& m, ReadSurveys read) {
  std::vector<Inventory> inventories;
  std::vector<std::pair<std::size_t, GuessedUnit>> guesses;  // by place in `inventories`
  Issues remarks;
  std::size_t stems = 0;
  for (ReadSurvey& survey : read) {
    if (!survey.inventory) continue;
    for (const Issue& issue : survey.inventory.issues) {
      if (auto guess = guess_in(issue)) {
        guess->path = survey.path;
        guesses.emplace_back(inventories.size(), std::move(*guess));
      } else {
        remarks.push_back(issue);
      }
    }
    stems += survey.inventory->stems.size();
    inventories.push_back(std::move(*survey.inventory));
  }
  const std::size_t count = inventories.size();
  m.notices.add_issues("Read " + ui::plural(count_of(count), "file", "files") + " with " + ui::plural(count_of(remarks.size()), "remark", "remarks"), remarks);
  tell_unread(m, read);
  if (inventories.empty()) return {false, "no usable row"};
  const std::vector<InventoryId> ids = add_all(m, std::move(inventories));
  for (auto& [place, guess] : guesses) {
    guess.inventory = ids[place];
    ask_for_unit(m, guess);
  }
  return {true, ui::plural(count_of(count), "inventory", "inventories") + " with " + ui::plural(count_of(stems), "stem", "stems")};
}

}  // namespace

void add_inventories(WindowModel& m, const std::vector<std::string>& paths) {
  if (paths.empty()) return;
  remember_folder(m, paths.front());
  const std::string what = paths.size() == 1 ? file_name(paths.front()) : ui::plural(count_of(paths.size()), "file", "files");
  m.view.step = ui::Step::inventories;
  m.jobs.start<ReadSurveys>(
      "Read " + what, JobLane::person, [paths](const Progress& progress) { return read_surveys(paths, progress); },
      [&m](ReadSurveys read) { return take_surveys(m, std::move(read)); });
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
