#pragma once
#include <map>
#include <optional>
#include <string>

#include "ui/frame.hpp"
#include "ui/widgets/widgets.hpp"

namespace stemwise::ui {

/// Step 1, right: how the selected inventory was understood, and what can be done with it.
class InventoryDetails {
 public:
  void draw(Widgets& w, Frame& frame);

 private:
  void draw_facts(Widgets& w, const Inventory& inventory);
  void draw_coverage(Widgets& w, Frame& frame, const Inventory& inventory);
  void draw_dbh_error(Widgets& w, Frame& frame, const Inventory& inventory);
  void fill_date(const Frame& frame, const Inventory& inventory);
  void draw_date(Widgets& w, Frame& frame, const Inventory& inventory);
  void draw_first_rows(Widgets& w, const Inventory& inventory);
  void count(const Inventory& inventory);

  struct Counts {
    std::uint64_t revision = ~0ULL;  ///< counted again after every change: an id can come back with other rows
    InventoryId id;
    std::size_t with_dbh = 0, with_z = 0, with_axis = 0, reconstructed = 0;
    double min_x = 0, max_x = 0, min_y = 0, max_y = 0, mean_dbh_m = 0;
  };
  Counts counts_;
  InventoryId dated_;
  std::uint64_t dated_at_ = ~0ULL;
  std::string date_;
  struct Refused {
    std::string text;  ///< typed for the date, and none
    std::optional<Date> instead_of;
  };
  std::map<InventoryId, Refused> refused_;
  const Project* refused_in_ = nullptr;
  InventoryId errors_of_;
  std::uint64_t errors_at_ = ~0ULL;
  double error_cm_ = 0.0;  ///< 0: estimated
};

}  // namespace stemwise::ui
