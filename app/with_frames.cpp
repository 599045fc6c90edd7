#include "app/with_frames.hpp"

#include "core/survey/build_global_inventory.hpp"
#include "io/read_frame_folder.hpp"

namespace stemwise {

std::shared_ptr<const Inventory> with_frames(std::shared_ptr<const Inventory> inventory, int threads, std::vector<std::string>& notes) {
  if (inventory->frames || inventory->source.format != "frame folder") return inventory;
  Result<Inventory> again = read_frame_folder(inventory->source.path, threads);
  if (!again || !again->frames) {
    notes.push_back(inventory->name + ": its frames are no longer in " + inventory->source.path + ", so it is aligned by its trees alone.");
    return inventory;
  }
  const auto frames = again->frames;
  if (with_global_stems(std::move(*again)).stems != inventory->stems) {
    notes.push_back(inventory->name + ": its trees are not those of the frames in " + inventory->source.path +
                    " as they are (a corrected trajectory, or other frames), so it is aligned by its trees alone.");
    return inventory;
  }
  auto copy = std::make_shared<Inventory>(*inventory);
  copy->frames = frames;
  return copy;
}

}  // namespace stemwise
