#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/date.hpp"
#include "core/base/ids.hpp"
#include "core/forest/frame_set.hpp"
#include "core/forest/stem.hpp"

namespace stemwise {

/// How an inventory was read, so that it can be shown, checked and read again.
struct InventorySource {
  std::string path;
  std::string format;              ///< "frame folder", "table", "GIS points", ...
  std::vector<std::string> notes;  ///< "dbh: column DBH, cm (by header)", one line per thing recognised or guessed
  std::optional<int> epsg;         ///< of the coordinates as read, where known

  bool operator==(const InventorySource&) const = default;
};

/// The trees of one survey of one forest in that survey's own frame, coordinates as the file has them (doubles: UTM-sized
/// numbers lose nothing; algorithms centre for themselves). Immutable once read: decisions lie beside it.
struct Inventory {
  InventoryId id;
  std::string name;
  std::optional<Date> date;
  std::vector<Stem> stems;
  InventorySource source;
  std::shared_ptr<const FrameSet> frames;  ///< where it came from frames; not part of equality

  bool operator==(const Inventory& o) const {
    return id == o.id && name == o.name && date == o.date && stems == o.stems && source == o.source;
  }
};

}  // namespace stemwise
