#include "app/with_frames.hpp"

#include "io/read_frame_folder.hpp"

namespace stemwise {

std::shared_ptr<const Inventory> with_frames(std::shared_ptr<const Inventory> inventory, int threads, std::vector<std::string>& notes) {
  if (inventory->frames || inventory->source.format != "frame folder") return inventory;
  const Result<Inventory> again = read_frame_folder(inventory->source.path, threads);
  if (!again || !again->frames) {
    notes.push_back(inventory->name + ": its frames are no longer in " + inventory->source.path + ", so it is aligned by its trees alone.");
    return inventory;
  }
  auto copy = std::make_shared<Inventory>(*inventory);
  copy->frames = again->frames;
  return copy;
}

}  // namespace stemwise
