#include "render/snapshot.hpp"

#include <stdexcept>

#include "render/surfaceless_context.hpp"
#include "render/viewport.hpp"

namespace stemwise::render {
namespace {

constexpr int most_pixels_per_side = 8192;

std::string title_of(const ProjectState& state) {
  if (!state.title.empty()) return state.title;
  std::string names;
  for (const InventoryId id : state.by_date())
    if (const Inventory* inventory = state.find(id)) names += (names.empty() ? "" : ", ") + inventory->name;
  return names;
}

}  // namespace

Result<Image> take_snapshot(const ProjectState& state, const Tables& tables, ViewOptions options, const SnapshotSettings& settings) {
  const auto [width, height] = settings.size;
  if (width < 1 || height < 1 || width > most_pixels_per_side || height > most_pixels_per_side)
    return Result<Image>::failure(Issue{.text = "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels cannot be drawn",
                                        .help = "1 to " + std::to_string(most_pixels_per_side) + " pixels a side"});
  const auto context = SurfacelessContext::create();
  if (!context) return Result<Image>::failure(context.issues);
  if (options.title.empty()) options.title = title_of(state);
  options.moving = false;
  try {
    Viewport viewport;
    viewport.set_options(options);
    viewport.sync(state, tables, 1);
    viewport.render(settings.size, settings.scale);
    return viewport.image();
  } catch (const std::runtime_error& error) {
    return Result<Image>::failure(Issue{.text = std::string("the picture cannot be drawn: ") + error.what()});
  }
}

Result<Done> write_snapshot(const ProjectState& state, const Tables& tables, const ViewOptions& options, const SnapshotSettings& settings,
                            const std::string& path) {
  const Result<Image> image = take_snapshot(state, tables, options, settings);
  return image ? write_png(*image, path) : Result<Done>::failure(image.issues);
}

}  // namespace stemwise::render
