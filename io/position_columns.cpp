#include "io/position_columns.hpp"

#include <algorithm>
#include <unordered_set>

namespace stemwise {
namespace {

using K = ColumnKind;

/// A candidate with what speaks for it.
struct Candidate {
  PositionColumns columns;
  int rank = 0;               ///< of the scheme and names, 0 best
  double distinct = 0.0;      ///< different pairs of values / rows
};

constexpr int geographic_rank = 1000;
constexpr int polar_rank = 2000;
constexpr int quadrat_rank = 3000;
constexpr int unknown_pair_rank = 500;

std::optional<std::size_t> best_of_kind(const StemTable& table, ColumnKind kind) {
  std::optional<std::size_t> best;
  int best_rank = 0;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const auto rank = name_rank(table.names[i], kind);
    if (rank && (!best || *rank < best_rank)) {
      best = i;
      best_rank = *rank;
    }
  }
  return best;
}

/// The header that equals this one but for y in the place of x (or north for east), for pairs nobody has listed.
std::optional<std::size_t> partner_by_letter(const StemTable& table, std::size_t x) {
  const std::string& base = table.names[x].base;
  for (const auto& [from, to] : {std::pair<std::string, std::string>("x", "y"), {"easting", "northing"}, {"east", "north"}}) {
    const std::size_t at = base.starts_with(from) ? 0 : base.ends_with(from) ? base.size() - from.size() : std::string::npos;
    if (at == std::string::npos) continue;
    std::string wanted = base;
    wanted.replace(at, from.size(), to);
    for (std::size_t i = 0; i < table.names.size(); ++i) {
      if (i != x && table.names[i].base == wanted) return i;
    }
  }
  return std::nullopt;
}

double distinct_share(const StemTable& table, const PositionColumns& columns) {
  std::unordered_set<std::string> seen;
  std::size_t numeric = 0;
  for (const GridRow& row : table.rows) {
    const auto a = table.cell(row, columns.first);
    const auto b = table.cell(row, columns.second);
    if (parse_quantity(a, table.style).kind != Quantity::Kind::number || parse_quantity(b, table.style).kind != Quantity::Kind::number) continue;
    ++numeric;
    seen.insert(std::string(a) + '|' + std::string(b));
  }
  if (numeric == 0) return 0.0;
  return static_cast<double>(seen.size()) / static_cast<double>(table.rows.size());
}

std::vector<Candidate> candidates_by_name(const StemTable& table) {
  std::vector<Candidate> found;
  const auto add = [&](PositionScheme scheme, std::size_t a, std::size_t b, int rank) {
    found.push_back({{scheme, a, b, 0, {}}, rank, 0.0});
  };
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (const auto pair = position_partner(table.names[i].base)) {
      for (std::size_t j = 0; j < table.names.size(); ++j) {
        if (j != i && table.names[j].base == pair->partner) add(PositionScheme::cartesian, i, j, pair->rank);
      }
    } else if (name_rank(table.names[i], K::local_x) && best_of_kind(table, K::quadrat)) {
      continue;  // only within its quadrat
    } else if (const auto j = partner_by_letter(table, i)) {
      add(PositionScheme::cartesian, i, *j, unknown_pair_rank + static_cast<int>(i));
    }
  }
  const auto pair_of = [&](K a, K b) {
    const auto i = best_of_kind(table, a);
    const auto j = best_of_kind(table, b);
    return i && j ? std::optional(std::pair(*i, *j)) : std::nullopt;
  };
  if (const auto p = pair_of(K::lon, K::lat)) add(PositionScheme::geographic, p->first, p->second, geographic_rank);
  if (const auto p = pair_of(K::azimuth, K::distance)) add(PositionScheme::polar, p->first, p->second, polar_rank);
  const auto quadrat = best_of_kind(table, K::quadrat);
  if (const auto p = pair_of(K::local_x, K::local_y); p && quadrat) {
    add(PositionScheme::quadrat, p->first, p->second, quadrat_rank);
    found.back().columns.quadrat = *quadrat;
  }
  return found;
}

Issue missing_columns(const StemTable& table) {
  std::string there;
  for (const std::string& name : table.header) there += (there.empty() ? "" : ", ") + (name.empty() ? std::string("(no name)") : name);
  return {Severity::error, table.file, table.header_row, {},
          "no columns with positions: expected x and y (or easting and northing, gx and gy, lon and lat, azimuth and distance); there are " + there,
          "name them with --map x=COLUMN --map y=COLUMN"};
}

std::string pair_text(const StemTable& table, const PositionColumns& c) { return table.header[c.first] + "/" + table.header[c.second]; }

/// What `--map` says about positions; nothing when it says nothing.
std::optional<Result<PositionColumns>> by_options(const StemTable& table, const ReadOptions& options) {
  const auto mapped = [&](const char* key) {
    const auto it = options.columns.find(key);
    return it == options.columns.end() || it->second.empty() ? std::nullopt : table.find(it->second);
  };
  const auto both = [&](const char* a, const char* b, PositionScheme scheme) -> std::optional<Result<PositionColumns>> {
    const bool any = options.columns.contains(a) || options.columns.contains(b);
    if (!any) return std::nullopt;
    auto i = mapped(a);
    auto j = mapped(b);
    const auto kind_a = *column_kind_from(a);
    const auto kind_b = *column_kind_from(b);
    if (!i && !options.columns.contains(a)) i = best_of_kind(table, kind_a);
    if (!j && !options.columns.contains(b)) j = best_of_kind(table, kind_b);
    if (i && !j && scheme == PositionScheme::cartesian && !options.columns.contains(b)) {
      const auto pair = position_partner(table.names[*i].base);
      for (std::size_t k = 0; pair && k < table.names.size(); ++k) {
        if (table.names[k].base == pair->partner) j = k;
      }
      if (!j) j = partner_by_letter(table, *i);
    }
    if (!i || !j) return Result<PositionColumns>::failure(missing_columns(table));
    return Result<PositionColumns>(PositionColumns{scheme, *i, *j, 0, {}});
  };
  if (auto found = both("x", "y", PositionScheme::cartesian)) return found;
  if (auto found = both("lon", "lat", PositionScheme::geographic)) return found;
  return both("azimuth", "distance", PositionScheme::polar);
}

}  // namespace

std::optional<double> median_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Result<PositionColumns> choose_position_columns(const StemTable& table, const ReadOptions& options) {
  if (auto given = by_options(table, options)) return *given;
  std::vector<Candidate> candidates = candidates_by_name(table);
  double most = 0.0;
  for (Candidate& c : candidates) {
    c.distinct = distinct_share(table, c.columns);
    most = std::max(most, c.distinct);
  }
  if (candidates.empty()) return Result<PositionColumns>::failure(missing_columns(table));
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.rank < b.rank; });
  const auto varies = [most](const Candidate& c) { return c.distinct >= 0.5 * most; };
  const auto chosen = std::find_if(candidates.begin(), candidates.end(), varies);
  PositionColumns columns = chosen->columns;
  for (const Candidate& c : candidates) {
    if (&c != &*chosen && varies(c) && most > 0.0) columns.others.push_back(pair_text(table, c.columns));
  }
  return columns;
}

}  // namespace stemwise
