#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/survey/review_queue.hpp"

namespace stemwise::ui {

struct Derived;
struct ViewState;

/// A part of the map, in metres in the reference's frame: what the map showed when it was chosen.
struct MapRegion {
  double low_x_m = 0.0, low_y_m = 0.0, high_x_m = 0.0, high_y_m = 0.0;
  bool operator==(const MapRegion&) const = default;
};

/// Which rows of the review queue are shown; N and P go through these only.
struct QueueFilter {
  bool open_only = true;
  std::string text;                    ///< in the tree's label or the reason
  std::optional<DoubtKind> kind;
  InventoryId inventory;               ///< none: of all surveys
  std::optional<MapRegion> region;
  bool operator==(const QueueFilter&) const = default;
  /// More than "undecided only": rows are out of sight that a person may forget.
  bool hides_rows() const { return !text.empty() || kind || inventory || region; }
};

/// Whether a row is of the part of the queue that the person looks at; decided or not. The fate chosen at the left counts too.
bool passes(const QueueFilter& filter, const ViewState& view, const Derived& derived, const QueueRow& row);

/// How much of that part is decided.
struct QueueProgress {
  int decided = 0;
  int all = 0;
};
QueueProgress progress_of(const QueueFilter& filter, const ViewState& view, const Derived& derived);

}  // namespace stemwise::ui
