#include "io/stem_columns.hpp"

#include <algorithm>
#include <unordered_set>

#include "io/stem_dates.hpp"
#include "io/stem_units.hpp"

namespace stemwise {
namespace {

using K = ColumnKind;

constexpr double unique_enough = 0.98;

Issue bad_option(const StemTable& table, std::string text, std::string help) {
  return {Severity::error, table.file, 0, {}, std::move(text), std::move(help)};
}

std::string header_list(const StemTable& table) {
  std::string text;
  for (const std::string& name : table.header) text += (text.empty() ? "" : ", ") + name;
  return text;
}

Issues check_options(const StemTable& table, const ReadOptions& options) {
  Issues issues;
  for (const auto& [word, header] : options.columns) {
    if (!column_kind_from(word)) {
      issues.push_back(bad_option(table, "--map " + word + ": no such column of ours", "x, y, z, lon, lat, azimuth, distance, dbh, circumference, height, id, species, status, date, plot"));
    } else if (!header.empty() && !table.find(header)) {
      issues.push_back(bad_option(table, "--map " + word + "=" + header + ": the file has no column " + header, "it has " + header_list(table)));
    }
  }
  for (const auto& [word, unit] : options.units) {
    if (!column_kind_from(word)) issues.push_back(bad_option(table, "--unit " + word + ": no such column of ours", "dbh, x, z, height, distance, azimuth"));
    if (unit_from_word(unit).empty()) issues.push_back(bad_option(table, "--unit " + word + "=" + unit + ": no such unit", "m, dm, cm, mm, ft, in, deg, gon, rad"));
  }
  return issues;
}

double share_of_numbers(const StemTable& table, std::size_t column) {
  return table.rows.empty() ? 0.0 : static_cast<double>(table.numbers(column).size()) / static_cast<double>(table.rows.size());
}

/// The best-named column of a kind; with several censuses that of `year`.
std::optional<std::size_t> best_named(const StemTable& table, K kind, std::optional<int> year) {
  std::optional<std::size_t> best;
  int best_rank = 0;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const auto rank = name_rank(table.names[i], kind);
    if (!rank || (table.names[i].year && table.names[i].year != year)) continue;
    const int penalty = year && table.names[i].year != year ? 1000 : 0;
    if (!best || *rank + penalty < best_rank) {
      best = i;
      best_rank = *rank + penalty;
    }
  }
  return best;
}

/// The diameter columns of a table with one column per census.
std::vector<std::size_t> census_columns(const StemTable& table) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (table.names[i].year && name_rank(table.names[i], K::dbh) && share_of_numbers(table, i) > 0.0) columns.push_back(i);
  }
  return columns;
}

/// The latest census, said aloud when there are several.
void choose_census(const StemTable& table, StemColumns& columns) {
  const auto censuses = census_columns(table);
  if (censuses.empty() || best_named(table, K::dbh, std::nullopt)) return;
  const auto later = [&](std::size_t a, std::size_t b) { return *table.names[a].year < *table.names[b].year; };
  const std::size_t last = *std::max_element(censuses.begin(), censuses.end(), later);
  columns.census_year = table.names[last].year;
  columns.at[static_cast<std::size_t>(K::dbh)] = last;
  columns.several_censuses = censuses.size() > 1;
  if (censuses.size() == 1) return;
  std::string all;
  for (const std::size_t c : censuses) all += (all.empty() ? "" : ", ") + table.header[c];
  columns.issues.push_back({Severity::warning, table.file, 0, table.header[last],
                            "the file has one diameter column per census (" + all + "); the latest was taken", "choose another with --map dbh=COLUMN"});
}

double uniqueness(const StemTable& table, std::size_t column) {
  std::unordered_set<std::string_view> seen;
  for (const GridRow& row : table.rows) {
    if (const auto cell = table.cell(row, column); !cell.empty()) seen.insert(cell);
  }
  return table.rows.empty() ? 0.0 : static_cast<double>(seen.size()) / static_cast<double>(table.rows.size());
}

/// The id that differs from row to row: the best name of those that are (nearly) unique.
void choose_id(const StemTable& table, StemColumns& columns) {
  std::optional<std::size_t> best;
  int best_rank = 0;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const auto rank = name_rank(table.names[i], K::id);
    if (!rank || i == columns.position.first || i == columns.position.second || (best && *rank >= best_rank)) continue;
    if (uniqueness(table, i) < unique_enough) continue;
    best = i;
    best_rank = *rank;
  }
  const auto named = [&](const char* base) {
    const auto at = std::find_if(table.names.begin(), table.names.end(), [&](const ColumnName& n) { return n.base == base; });
    return at == table.names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - table.names.begin()));
  };
  const auto tag = named("tag") ? named("tag") : named("treeid");
  const auto stem_tag = named("stemtag");
  if (tag && stem_tag && (!best || table.names[*best].base == "objectid" || table.names[*best].base == "fid")) {
    columns.tag = tag;
    columns.stem_tag = stem_tag;
    return;
  }
  columns.at[static_cast<std::size_t>(K::id)] = best ? best : best_named(table, K::id, std::nullopt);
}

void choose_by_name(const StemTable& table, StemColumns& columns) {
  for (const K kind : {K::z, K::dbh, K::circumference, K::dbh_approximation, K::height, K::species, K::status, K::axis_x, K::axis_y, K::axis_z,
                       K::number_clusters, K::reconstructed, K::score}) {
    auto& slot = columns.at[static_cast<std::size_t>(kind)];
    if (!slot) slot = best_named(table, kind, columns.census_year);
    if (slot && (*slot == columns.position.first || *slot == columns.position.second)) slot.reset();
  }
  if (table.find("tree_id") && table.find("position_sd_m")) columns.at[static_cast<std::size_t>(K::height)].reset();  // our own export: above the ellipsoid
  const auto dbh = columns[K::dbh];
  if (dbh && share_of_numbers(table, *dbh) == 0.0 && columns[K::circumference]) columns.at[static_cast<std::size_t>(K::dbh)].reset();
  if (columns[K::dbh]) columns.at[static_cast<std::size_t>(K::circumference)].reset();
  choose_id(table, columns);
  columns.genus = table.find("Genus");
  if (!columns[K::species] || table.names[*columns[K::species]].base != "species") columns.genus.reset();
  columns.at[static_cast<std::size_t>(K::date)] = choose_date_column(table);
}

void take_options(const StemTable& table, const ReadOptions& options, StemColumns& columns) {
  for (const auto& [word, header] : options.columns) {
    const K kind = *column_kind_from(word);
    columns.at[static_cast<std::size_t>(kind)] = header.empty() ? std::nullopt : table.find(header);
    if (header.empty() && kind == K::species) columns.genus.reset();
    if (kind == K::id) columns.tag.reset(), columns.stem_tag.reset();
    if (kind == K::dbh && !header.empty()) columns.at[static_cast<std::size_t>(K::circumference)].reset();
    if (kind == K::circumference && !header.empty()) columns.at[static_cast<std::size_t>(K::dbh)].reset();
  }
}

/// A header that stands twice: which of the columns was meant?
void warn_of_repeated_headers(const StemTable& table, StemColumns& columns) {
  std::vector<std::size_t> used = {columns.position.first, columns.position.second};
  for (const auto& at : columns.at)
    if (at) used.push_back(*at);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const std::size_t at : used) {
    const auto same = std::count(table.header.begin(), table.header.end(), table.header[at]);
    if (same < 2) continue;
    columns.issues.push_back({Severity::warning, table.file, table.header_row, table.header[at],
                              "the header has this name " + std::to_string(same) + " times; column " + std::to_string(at + 1) + " was read", "give the other column another name"});
  }
}

/// "species: column sp", one line per column taken, except those that the units tell.
void note_columns(const StemTable& table, StemColumns& columns) {
  for (const K kind : {K::id, K::species, K::status, K::date, K::axis_x}) {
    if (const auto at = columns[kind])
      columns.notes.push_back(std::string(kind == K::axis_x ? "axis" : to_string(kind)) + ": column " + table.header[*at] + (kind == K::date ? date_reading_of(table, *at).in_words() : ""));
  }
  if (columns.tag) columns.notes.push_back("id: columns " + table.header[*columns.tag] + " and " + table.header[*columns.stem_tag]);
  if (!columns[K::id] && !columns.tag) columns.notes.push_back("id: row number");
  if (!columns[K::dbh] && !columns[K::circumference]) {
    columns.issues.push_back({Severity::warning, table.file, table.header_row, {}, "no column with a diameter; there are " + header_list(table),
                              "name it with --map dbh=COLUMN"});
  }
  if (columns.position.others.empty()) return;
  std::string others;
  for (const std::string& pair : columns.position.others) others += (others.empty() ? "" : ", ") + pair;
  columns.notes.push_back("other columns that could be positions: " + others);
}

}  // namespace

Result<StemColumns> recognise_columns(const StemTable& table, const ReadOptions& options) {
  if (Issues issues = check_options(table, options); !issues.empty()) return Result<StemColumns>::failure(std::move(issues));
  const auto position = choose_position_columns(table, options);
  if (!position) return Result<StemColumns>::failure(position.issues);
  StemColumns columns;
  columns.position = *position;
  if (const auto it = options.columns.find("dbh"); it != options.columns.end() && !it->second.empty()) {
    columns.census_year = table.names[*table.find(it->second)].year;
    columns.several_censuses = columns.census_year && census_columns(table).size() > 1;
  } else {
    choose_census(table, columns);
  }
  choose_by_name(table, columns);
  take_options(table, options, columns);
  decide_units(table, options, columns);
  note_columns(table, columns);
  warn_of_repeated_headers(table, columns);
  return columns;
}

}  // namespace stemwise
