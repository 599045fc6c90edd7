#pragma once
#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// The selected tree: what it is, how sure that is and why, its history, what else it could be, and what to do with it.
class Inspector {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_nothing(Widgets& w, Frame& frame);
  void draw_group(Widgets& w, Frame& frame);  ///< several trees at once
  void draw_head(Widgets& w, Frame& frame, const TreeRow& tree);
  void draw_confidence(Widgets& w, Frame& frame, const TreeRow& tree);
  void draw_history(Widgets& w, Frame& frame, const TreeRow& tree);
  void draw_sighting(Widgets& w, Frame& frame, const ObservationRow& row);
  void draw_buttons(Widgets& w, Frame& frame);
  void draw_alternatives(Widgets& w, Frame& frame, const TreeRow& tree);
  void draw_note(Widgets& w, Frame& frame, const TreeRow& tree);

  /// A stem of another survey that stands near.
  struct Neighbour {
    StemRef from, to;
    double distance_m = 0.0;
    bool rejected = false;  ///< by hand
  };
  void find_neighbours(const Frame& frame, const TreeRow& tree);
  void draw_alternative(Widgets& w, Frame& frame, const Neighbour& stem, bool current);

  std::uint64_t neighbours_at_ = ~0ULL;  ///< revision of the tables that they are of
  TreeId neighbours_of_;
  std::vector<Neighbour> neighbours_;
  TreeId noted_;        ///< the tree whose note is in the field
  std::string note_;
  bool is_note_typed_ = false;  ///< and not in the project yet
};

}  // namespace stemwise::ui
