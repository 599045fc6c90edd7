#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/window/project_io.hpp"
#include "app/window/requests.hpp"
#include "ui/text/format.hpp"

namespace stemwise {
namespace {

namespace fs = std::filesystem;

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

void show(WindowModel& m) {
  m.status.imports.clear();
  for (const PendingImport& pending : m.imports) m.status.imports.push_back(import_view(pending));
}

/// Into the project, in the order given; what could not be read stays outside and is named.
JobVerdict take(WindowModel& m, std::vector<PendingImport> imports) {
  ReadSurveys read;
  for (PendingImport& pending : imports) {
    if (!pending.settings.take) continue;
    ReadSurvey survey{pending.preview.path, std::move(pending.preview.inventory)};
    if (survey.inventory && !pending.settings.name.empty()) survey.inventory->name = pending.settings.name;
    read.push_back(std::move(survey));
  }
  return read.empty() ? JobVerdict{false, "nothing was taken"} : take_surveys(m, std::move(read));
}

JobVerdict arrived(WindowModel& m, std::vector<PendingImport> read, bool ask) {
  const bool doubt = std::any_of(read.begin(), read.end(), is_in_doubt);
  if (!ask && !doubt && m.imports.empty()) {
    for (const PendingImport& pending : read) {
      if (pending.remembered) m.notices.add(Severity::note, file_name(pending.preview.path) + " was read as you chose for the last file with this header");
    }
    return take(m, std::move(read));
  }
  const std::int64_t files = static_cast<std::int64_t>(read.size());
  std::move(read.begin(), read.end(), std::back_inserter(m.imports));
  m.view.dialog = ui::Dialog::import;
  show(m);
  return {true, ui::plural(files, "file waits", "files wait") + " for a decision"};
}

void read_again(WindowModel& m, std::size_t index) {
  PendingImport& pending = m.imports[index];
  pending.reading = true;
  const int generation = ++pending.generation;
  m.jobs.start<InventoryPreview>(
      "Read " + file_name(pending.preview.path), JobLane::tables,
      [path = pending.preview.path, settings = pending.settings](const Progress& progress) { return read_again(path, settings, progress); },
      [&m, generation, path = pending.preview.path](InventoryPreview preview) -> JobVerdict {
        const auto at = std::find_if(m.imports.begin(), m.imports.end(), [&](const PendingImport& p) { return p.preview.path == path && p.generation == generation; });
        if (at == m.imports.end()) return {true, ""};
        at->preview = std::move(preview);
        at->reading = false;
        show(m);
        return {true, ""};
      });
}

/// One Escape is no decision to do all the choosing again: what was edited can be had back.
void keep_cancelled(WindowModel& m, std::vector<PendingImport> imports) {
  if (std::none_of(imports.begin(), imports.end(), [](const PendingImport& p) { return p.edited; })) return;
  const std::string files = ui::plural(static_cast<std::int64_t>(imports.size()), "file", "files");
  const auto kept = std::make_shared<std::vector<PendingImport>>(std::move(imports));
  const auto bring_back = [&m, kept] {
    m.imports = std::move(*kept);
    for (std::size_t i = 0; i < m.imports.size(); ++i)
      if (m.imports[i].reading) read_again(m, i);  // that reading came back to a dialog that was gone
    m.view.dialog = ui::Dialog::import;
    show(m);
  };
  m.notices.add(Severity::note, "Import cancelled", {Issue{Severity::note, "", 0, "", "What you set for " + files + " is kept while this project is open.", ""}}, {{"Bring it back", bring_back}, {"Dismiss", {}}});
}

/// What the person saw and took holds for the next file with this header: also units that were guessed and left standing.
void remember(WindowModel& m, const PendingImport& pending) {
  if (!pending.preview.inventory || !pending.settings.take) return;
  ReadOptions options = read_options(pending.settings);
  for (const ColumnPreview& column : pending.preview.columns) {
    if (column.guessed) options.units.try_emplace(column.kind, column.unit);
  }
  m.import_memory.remember(pending.preview.header, options);
}

}  // namespace

void add_inventories(WindowModel& m, const std::vector<std::string>& paths, bool ask) {
  if (paths.empty()) return;
  remember_folder(m, paths.front());
  const std::string what = paths.size() == 1 ? file_name(paths.front()) : ui::plural(static_cast<std::int64_t>(paths.size()), "file", "files");
  m.view.step = ui::Step::inventories;
  m.jobs.start<std::vector<PendingImport>>(
      "Read " + what, JobLane::person,
      [paths, memory = m.import_memory](const Progress& progress) {
        std::vector<PendingImport> read;
        for (std::size_t i = 0; i < paths.size(); ++i) {
          const auto share = [&](double k) { return (static_cast<double>(i) + k) / static_cast<double>(paths.size()); };
          progress.at(share(0.0), "Reading " + file_name(paths[i]));
          read.push_back(read_pending(paths[i], memory, progress.stage(share(0.1), share(1.0))));
        }
        return read;
      },
      [&m, ask](std::vector<PendingImport> read) { return arrived(m, std::move(read), ask); });
}

void edit_import(WindowModel& m, const ui::request::ImportEdit& edit) {
  if (edit.file >= m.imports.size()) return;
  PendingImport& pending = m.imports[edit.file];
  ui::ImportSettings before = std::exchange(pending.settings, edit.settings);
  pending.edited = true;
  before.take = edit.settings.take;
  before.name = edit.settings.name;
  before.no_date = edit.settings.no_date;
  if (!(before == edit.settings)) {
    pending.remembered = false;
    read_again(m, edit.file);
  }
  show(m);
}

void finish_import(WindowModel& m, bool take_them) {
  m.view.dialog = ui::Dialog::none;
  m.status.imports.clear();
  std::vector<PendingImport> imports = std::exchange(m.imports, {});
  if (!take_them) return keep_cancelled(m, std::move(imports));
  for (const PendingImport& pending : imports) remember(m, pending);
  // Seen in the dialog: what could not be read is left out without a second word.
  std::erase_if(imports, [](const PendingImport& p) { return !p.preview.inventory; });
  for (PendingImport& pending : imports) pending.preview.inventory.issues.clear();
  take(m, std::move(imports));
}

}  // namespace stemwise
