#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/survey/tables.hpp"

namespace stemwise {

// Components of change between two consecutive surveys: what the stock of the earlier one became, and what the stock of the
// later one is made of. Every living stem with a DBH is in exactly one component, so that the components balance:
//   later stock - earlier stock = survivor growth + all that came - all that went.

enum class Component {
  survivor,             ///< seen alive by both: earlier and later basal area
  ingrowth,             ///< new, and small enough to have grown in
  missed_earlier,       ///< new to the earlier survey, but too large to be ingrowth, or known from before it
  new_unresolved,       ///< new, at the edge of the coverage
  not_surveyed_before,  ///< new, where the earlier survey did not look
  dead,                 ///< a person or a field code says so
  removed,              ///< a person says so
  missing,              ///< gone inside the later survey's coverage: dead or removed, a person decides which
  missed_later,         ///< gone, but seen again afterwards
  gone_unresolved,      ///< gone, at the edge of the coverage
  not_surveyed_after    ///< gone, where the later survey did not look
};
inline constexpr std::size_t component_count = 11;
const char* to_string(Component component);        ///< "missed_earlier"
const char* component_label(Component component);  ///< "Missed earlier"
bool is_loss(Component component);                 ///< counted at the earlier survey, by its earlier DBH

/// Stems and their basal area at both ends; losses have no later, what came no earlier basal area.
struct ComponentSum {
  int stems = 0;
  double earlier_sq_m = 0.0;
  double later_sq_m = 0.0;
  double growth_sq_m() const { return later_sq_m - earlier_sq_m; }
};

using ComponentTable = std::array<ComponentSum, component_count>;
const ComponentSum& of(const ComponentTable& table, Component component);
/// Stock of the earlier (survivors and losses) and of the later survey (survivors and what came).
ComponentSum earlier_stock(const ComponentTable& table);
ComponentSum later_stock(const ComponentTable& table);

struct SpeciesChange {
  std::string species;  ///< as the file says it, of the earlier survey where there; "" where none is given
  ComponentTable table{};
};

/// Losses and survivors by their earlier DBH, what came by its later DBH; class [low, high).
struct ClassChange {
  double low_cm = 0.0, high_cm = 0.0;
  ComponentTable table{};
};

struct ChangeOptions {
  std::optional<double> area_ha;    ///< given by a person; without it the ground that both coverages share
  double class_width_cm = 5.0;      ///< classes [k w, (k+1) w)
};

/// One step from a survey to the next.
struct StandChange {
  InventoryId from, to;
  std::optional<double> years;          ///< median of the stems' own spans, else of the surveys' dates
  std::optional<double> area_ha;        ///< nothing where no area is known: then nothing is said per hectare
  std::string area_source;              ///< "given", "ground covered by both surveys"
  ComponentTable all{};
  int without_dbh = 0;                  ///< living stems that lack a DBH at an end where they were seen: in no component
  int beyond_drawn = 0;                 ///< trees outside the ground that a person drew for a survey that saw them: in no component
  std::optional<double> survivor_growth_sq_m_per_year;  ///< each stem's growth over its own years, summed
  std::vector<SpeciesChange> by_species;                ///< sorted by name
  std::vector<ClassChange> by_class;                    ///< ascending, without empty ones at both ends

  double net_change_sq_m() const { return later_stock(all).later_sq_m - earlier_stock(all).earlier_sq_m; }
};

/// Periodic annual increment, per year and, where an area is known, per hectare (Husch, Beers and Kershaw 2003, ch. 15). Gross growth is
/// survivor growth; with ingrowth added; net growth takes losses off again. Trees that were missed or not surveyed at one
/// end are in none: their arrival is no growth.
struct PeriodicIncrement {
  bool per_ha = false;
  double survivor_growth_sq_m = 0.0;
  double ingrowth_sq_m = 0.0;
  double mortality_sq_m = 0.0;  ///< dead and missing, by earlier DBH
  double removal_sq_m = 0.0;
  double gross_growth_sq_m() const { return survivor_growth_sq_m; }
  double gross_growth_with_ingrowth_sq_m() const { return survivor_growth_sq_m + ingrowth_sq_m; }
  double net_growth_sq_m() const { return survivor_growth_sq_m + ingrowth_sq_m - mortality_sq_m - removal_sq_m; }
};
/// Nothing without years.
std::optional<PeriodicIncrement> periodic_increment(const StandChange& change);

/// One row per step between consecutive placed surveys by date.
std::vector<StandChange> stand_changes(const ProjectState& state, const Tables& tables, const ChangeOptions& options = {});

}  // namespace stemwise
