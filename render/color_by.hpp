#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/project/project_state.hpp"
#include "core/survey/tables.hpp"
#include "render/palette.hpp"

namespace stemwise::render {

/// What the colour of a stem means; words of cli.md's --color-by.
enum class ColorBy { inventory, fate, dbh, growth, residual, confidence, times_seen };
const char* to_string(ColorBy by);     ///< "times_seen"
const char* label_of(ColorBy by);      ///< "Times seen"
std::optional<ColorBy> color_by_from(const std::string& word);
inline constexpr ColorBy all_color_bys[] = {ColorBy::inventory, ColorBy::fate,       ColorBy::dbh,       ColorBy::growth,
                                            ColorBy::residual,  ColorBy::confidence, ColorBy::times_seen};

/// A key to the colours, as a value: whoever draws it (viewport, panel, report) needs nothing else.
struct LegendEntry {
  std::string label;
  Rgba colour;
  MarkShape shape = MarkShape::disc;
  std::optional<int> count;
  bool operator==(const LegendEntry&) const = default;
};
struct LegendTick {
  double at = 0.0;  ///< along the gradient, 0..1
  std::string label;
  bool operator==(const LegendTick&) const = default;
};
struct Legend {
  std::string title;  ///< "DBH"
  std::string unit;   ///< "cm", "" where there is none
  std::vector<LegendEntry> entries;
  std::vector<Rgba> gradient;  ///< evenly spaced; empty for a key of entries only
  std::vector<LegendTick> ticks;
  bool operator==(const Legend&) const = default;
};

struct MarkStyle {
  Rgba colour;
  MarkShape shape = MarkShape::disc;
};

/// Colours for the rows of one project at one moment: ranges are taken from the data once (2nd to 98th percentile,
/// rounded), so every row after that is a look-up.
class Colouring {
 public:
  Colouring(const ProjectState& state, const Tables& tables, ColorBy by, Theme theme);

  /// `tree` may be null (a stem that belongs to no tree yet). `whole` says that the mark stands for the whole tree, not for
  /// one sighting: then the tree's own fate is shown.
  MarkStyle style_of(const ObservationRow& row, const TreeRow* tree, bool whole) const;
  /// For a stem of an inventory that has no place yet.
  MarkStyle style_of_unplaced(InventoryId inventory, const Stem& stem) const;
  Rgba colour_of_inventory(InventoryId inventory) const;
  const Legend& legend() const { return legend_; }
  ColorBy by() const { return by_; }

 private:
  struct Range {
    double low = 0.0;
    double high = 1.0;
  };
  std::optional<double> change_of(const TreeRow& tree) const;
  Rgba sequential(const std::optional<double>& value) const;
  void describe_inventories(const ProjectState& state, const Tables& tables);
  void describe_fates(const Tables& tables);
  void describe_times_seen(const Tables& tables);
  void describe_sequential(std::vector<double> values, std::string unit, double scale, std::optional<Range> fixed);
  void describe_growth(const Tables& tables);

  ColorBy by_;
  Theme theme_;
  std::vector<InventoryId> order_;  ///< surveys in the order of their colours
  Range range_;                     ///< in the row's own unit (m, m per year, 1)
  double growth_error_m_per_year_ = 0.0;
  bool is_total_change_ = false;    ///< no survey pair has dates: DBH change as a whole instead of per year
  Legend legend_;
};

}  // namespace stemwise::render
