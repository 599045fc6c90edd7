#include "io/repeated_stems.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <unordered_map>

#include "io/plot_filter.hpp"

namespace stemwise {
namespace {

using K = ColumnKind;

bool counts_rows(const StemTable& table, std::size_t column) {
  static constexpr std::array<std::string_view, 7> names = {"unnamed0", "row", "rowid", "index", "fid", "objectid", "ogcfid"};
  return table.header[column].empty() || std::find(names.begin(), names.end(), table.names[column].base) != names.end();
}

/// What a row says, its number apart.
std::string said_in(const StemTable& table, const StemColumns& columns, const GridRow& row) {
  std::string text;
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    if (counts_rows(table, c) && c != columns[K::id]) continue;
    text += table.cell(row, c);
    text += '\x1f';
  }
  return text;
}

}  // namespace

Issues leave_out_repeated_rows(const StemTable& table, const StemColumns& columns, std::vector<Stem>& stems, std::vector<std::size_t>& rows) {
  const bool named = columns[K::id] || columns.tag;
  std::unordered_map<std::string, std::size_t> first;
  std::size_t kept = 0, repeated = 0;
  Issue issue{Severity::warning, table.file, 0, {}, {}, {}};
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const auto [earlier, is_new] = first.try_emplace(said_in(table, columns, table.rows[rows[i]]), rows[i]);
    if (!is_new && repeated++ == 0) {
      issue.row = stems[i].source_row;
      issue.text = "says the very same as row " + std::to_string(table.rows[earlier->second].row);
    }
    if (!is_new && named) continue;
    if (kept != i) stems[kept] = std::move(stems[i]), rows[kept] = rows[i];
    ++kept;
  }
  stems.resize(kept);
  rows.resize(kept);
  if (repeated == 0) return {};
  if (repeated > 1) issue.text += " (and " + std::to_string(repeated - 1) + " more rows repeat an earlier one)";
  issue.text += named ? (repeated > 1 ? "; they are left out" : "; it is left out") : "; kept, for the rows have no ids";
  if (!named) issue.help = "take repeated rows out of the file, or name the trees";
  return {issue};
}

Issues warn_of_repeated_ids(const StemTable& table, const StemColumns& columns, const std::vector<Stem>& stems) {
  constexpr double one_tree_m = 2.0;
  if (!columns[K::id] || columns.tag || !plot_columns_with_several_values(table).empty()) return {};
  std::unordered_map<std::string_view, const Stem*> first;
  std::size_t repeated = 0;
  Issue issue{Severity::warning, table.file, 0, table.header[*columns[K::id]], {}, "matches are named by these ids: give every tree its own"};
  for (const Stem& stem : stems) {
    const auto [earlier, is_new] = first.try_emplace(stem.source_id, &stem);
    if (is_new || std::hypot(stem.x_m - earlier->second->x_m, stem.y_m - earlier->second->y_m) <= one_tree_m) continue;
    if (repeated++ > 0) continue;
    issue.row = stem.source_row;
    issue.text = "\"" + stem.source_id + "\" is already the id of row " + std::to_string(earlier->second->source_row) + ", which stands elsewhere; both are kept";
  }
  if (repeated > 1) issue.text += " (and " + std::to_string(repeated - 1) + " more such rows)";
  return repeated > 0 ? Issues{issue} : Issues{};
}

}  // namespace stemwise
