#include "io/stem_table.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "io/delimited_text.hpp"

namespace stemwise {
namespace {

constexpr std::size_t rows_searched_for_header = 60;
constexpr int position_bonus = 10;

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

bool has_base(const std::vector<ColumnName>& names, const std::string& base) {
  return std::any_of(names.begin(), names.end(), [&](const ColumnName& n) { return n.base == base; });
}

bool has_kind(const std::vector<ColumnName>& names, ColumnKind kind) {
  return std::any_of(names.begin(), names.end(), [&](const ColumnName& n) { return name_rank(n, kind).has_value(); });
}

bool gives_positions(const std::vector<ColumnName>& names) {
  using K = ColumnKind;
  for (const ColumnName& name : names) {
    if (const auto pair = position_partner(name.base); pair && has_base(names, pair->partner)) return true;
  }
  return (has_kind(names, K::lon) && has_kind(names, K::lat)) || (has_kind(names, K::azimuth) && has_kind(names, K::distance)) ||
         (has_kind(names, K::local_x) && has_kind(names, K::local_y) && has_kind(names, K::quadrat));
}

/// R writes row names without a header: every row has one field more than the header.
bool has_row_names(const StemTable& table) {
  if (table.rows.empty()) return false;
  return std::all_of(table.rows.begin(), table.rows.end(), [&](const GridRow& r) { return r.cells.size() == table.header.size() + 1; }) &&
         std::any_of(table.rows.begin(), table.rows.end(), [](const GridRow& r) { return !r.cells.back().empty(); });
}

}  // namespace

std::optional<std::size_t> StemTable::find(const std::string& name) const {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i] == name) return i;
  }
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (lower(header[i]) == lower(name)) return i;
  }
  const ColumnName wanted = parse_column_name(name);
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (!wanted.base.empty() && names[i].base == wanted.base && names[i].year == wanted.year) return i;
  }
  return std::nullopt;
}

std::vector<double> StemTable::numbers(std::size_t column) const {
  std::vector<double> out;
  out.reserve(rows.size());
  for (const GridRow& row : rows) {
    const Quantity q = parse_quantity(cell(row, column), style);
    if (q.kind == Quantity::Kind::number) out.push_back(q.value);
  }
  return out;
}

int header_score(const GridRow& row, const ReadOptions& options) {
  std::vector<ColumnName> names;
  int mapped = 0;
  for (const std::string& cell : row.cells) {
    names.push_back(parse_column_name(cell));
    for (const auto& [kind, header] : options.columns) mapped += !cell.empty() && lower(cell) == lower(header) ? 1 : 0;
    if (!options.plot_column.empty() && lower(cell) == lower(options.plot_column)) ++mapped;
  }
  int kinds = 0;
  for (std::size_t k = 0; k < column_kind_count; ++k) kinds += has_kind(names, static_cast<ColumnKind>(k)) ? 1 : 0;
  const bool positions = gives_positions(names);
  if (kinds + mapped == 0 && !positions) return 0;
  return kinds + 3 * mapped + (positions ? position_bonus : 0);
}

std::optional<std::size_t> find_header(const Grid& grid, const ReadOptions& options) {
  std::optional<std::size_t> best;
  int best_score = 1;  // one name alone may be chance
  for (std::size_t i = 0; i < std::min(grid.rows.size(), rows_searched_for_header); ++i) {
    const int score = header_score(grid.rows[i], options);
    if (score > best_score) {
      best_score = score;
      best = i;
    }
  }
  return best;
}

StemTable stem_table_from(Grid grid, std::size_t header_index, const std::string& file, bool comma_delimits) {
  StemTable table;
  table.file = file;
  table.header_row = grid.rows[header_index].row;
  table.header = std::move(grid.rows[header_index].cells);
  table.rows.assign(std::make_move_iterator(grid.rows.begin() + static_cast<std::ptrdiff_t>(header_index) + 1),
                    std::make_move_iterator(grid.rows.end()));
  if (has_row_names(table)) table.header.insert(table.header.begin(), "row");
  for (const std::string& cell : table.header) table.names.push_back(parse_column_name(cell));
  NumberStyleVotes votes;
  for (const GridRow& row : table.rows) {
    for (const std::string& cell : row.cells) votes.add(cell);
  }
  table.style = votes.decide(comma_delimits);
  if (header_index > 0) table.notes.push_back("header in row " + std::to_string(table.header_row) + ", what stands above it was left out");
  if (table.style.decimal_comma) table.notes.push_back("decimal sign: comma");
  if (!table.style.certain) {
    table.issues.push_back({Severity::warning, file, 0, {},
                            std::string("numbers like 1,234 were read with a decimal ") + (table.style.decimal_comma ? "comma" : "point"),
                            "if that is wrong, write the numbers without thousands signs"});
  }
  return table;
}

}  // namespace stemwise
