#include "ui/panels/edit_log_tab.hpp"

#include <imgui.h>

#include "ui/panels/table_view.hpp"
#include "ui/text/format.hpp"

namespace stemwise::ui {

void EditLogTab::draw(Widgets& w, Frame& frame) {
  const std::vector<EditLogEntry>& log = frame.state().edit_log;
  if (revision_ != frame.revision || filtered_by_ != filter_) {
    revision_ = frame.revision;
    filtered_by_ = filter_;
    rows_.clear();
    for (std::size_t i = log.size(); i-- > 0;) {
      const EditLogEntry& e = log[i];
      if ((e.what + e.author + e.note + e.before + e.after).find(filter_) != std::string::npos) rows_.push_back(i);
    }
  }
  if (!log.empty()) draw_filter(w, "log/filter", filter_, "Filter by tree, author or note");
  TableView table;
  table.path = "log";
  table.columns = {{"Time (UTC)", 1.32f}, {"Who", 0.62f}, {"What", 2.15f}, {"Before", 0.88f}, {"After", 1.1f}, {"Note", 0.5f}};
  table.least_width = w.px(600);
  table.rows = rows_.size();
  table.cell = [&](std::size_t row, std::size_t column) -> TableCell {
    const EditLogEntry& e = log[rows_[row]];
    const std::string time = e.time_utc.size() >= 16 ? e.time_utc.substr(0, 10) + " " + e.time_utc.substr(11, 5) : e.time_utc;
    const std::string cells[] = {time, e.author, e.what, sentence(e.before), sentence(e.after), e.note};
    return {cells[column], column == 0 ? Tone::secondary : Tone::text};
  };
  table.empty_text = log.empty() ? "No decision by hand yet." : "No entry fits the filter.";
  draw_table(w, table);
}

}  // namespace stemwise::ui
