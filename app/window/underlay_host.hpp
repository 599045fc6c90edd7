#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/underlay/underlay_request.hpp"
#include "render/view_options.hpp"
#include "ui/view_state.hpp"

namespace stemwise {

using UnderlayData = std::variant<std::shared_ptr<const RasterUnderlay>, std::shared_ptr<const CloudUnderlay>>;

/// A file that can lie under the stems, by its suffix. Text grids (.asc) are taken for tables unless they are chosen as an underlay.
bool is_underlay(const std::string& path);

/// What of the underlays was read, and for which place of the project on the earth.
class UnderlayHost {
 public:
  /// A reading begins; an earlier one of the same underlay is no longer waited for. The number tells them apart.
  int begin(int id, InventoryId frame, UnderlayRequest request);
  void set_job(int id, int job) { entries_[id].job = job; }
  bool is_awaited(int id, int reading) const;
  void take(int id, UnderlayData data);
  void fail(int id);  ///< there is nothing to show until the project has changed
  void forget(int id);
  InventoryId frame_of(int id) const;  ///< with which it was read last
  std::optional<int> job_of(int id) const;
  /// The file has to be read (again) to lie where this says: other georeference, other frame, or stems beyond what was read.
  bool is_stale(int id, const UnderlayRequest& now) const;

  /// Those that are read and switched on, lowest first.
  std::vector<render::ShownUnderlay> shown(const ui::ViewState& view) const;

  int next_id() { return ++last_id_; }
  std::uint64_t tended_revision = 0;  ///< of the project, when staleness was last looked for

 private:
  struct Entry {
    UnderlayRequest request;
    InventoryId frame;
    int reading = 0;
    std::optional<int> job;
    std::optional<UnderlayData> data;
  };
  std::map<int, Entry> entries_;
  int last_id_ = 0, last_reading_ = 0;
};

}  // namespace stemwise
