#include "app/window/project_io.hpp"
#include "app/window/requests.hpp"
#include "core/project/commands.hpp"
#include "io/read_rule_pack.hpp"

namespace stemwise {

void choose_rules(WindowModel& m, const std::optional<RulePack>& pack) {
  std::vector<CommandPtr> commands;
  for (auto& [key, value] : settings_of(pack)) commands.push_back(set_setting(key, value));
  m.execute(group(pack ? "Rules for growth: " + pack->name : std::string("No rules for growth"), std::move(commands)));
}

void read_own_rules(WindowModel& m, const std::string& path) {
  remember_folder(m, path);
  m.jobs.start<Result<RulePack>>(
      "Read " + path, JobLane::person, [path](const Progress&) { return read_rule_pack(path); },
      [&m](Result<RulePack> read) -> JobVerdict {
        m.notices.add_issues(read ? "Rules were read with remarks" : "The rules could not be read", read.issues);
        if (!read) return {false, "not readable"};
        m.previews.own_rules = std::move(*read);
        return {true, "read: choose them in step 5"};
      });
}

void write_field_check_sheet(WindowModel& m, const ui::request::WriteFieldCheck& what) {
  write_over(m, what.path, [&m, what] {
    m.jobs.start<Result<Done>>(
        "Write the field check sheet", JobLane::person, [what, state = m.document.state()](const Progress&) { return write_field_check(state, what); },
        [&m, path = what.path](Result<Done> written) { return tell_written(m, path, written); });
  });
}

void save_chart(WindowModel& m, const ui::request::SaveChart& what) {
  write_over(m, what.path, [&m, what] { static_cast<void>(tell_written(m, what.path, m.charts.write(what.chart, what.path))); });
}

}  // namespace stemwise
