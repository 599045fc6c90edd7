#include "core/treeloc/localizer.hpp"

#include <algorithm>
#include <atomic>

#include "core/base/parallel.hpp"
#include "core/treeloc/published_localizer.hpp"
#include "core/treeloc/stemwise_localizer.hpp"

namespace stemwise::treeloc {

std::unique_ptr<Localizer> make_localizer(const Settings& settings) {
  return settings.method == Method::stemwise ? make_stemwise_localizer(settings) : make_published_localizer(settings);
}

std::vector<Localization> localize_all(const Localizer& localizer, std::span<const Scene> queries,
                                       std::span<const std::uint32_t> scene_limits, int threads, const Progress& progress) {
  constexpr std::size_t per_block = 32;  // one worker per block: its buffers are made once for many queries
  std::vector<Localization> found(queries.size());
  std::atomic<std::size_t> done{0};
  parallel_for((queries.size() + per_block - 1) / per_block, threads, [&](std::size_t block) {
    const auto worker = localizer.worker();
    const std::size_t end = std::min(queries.size(), (block + 1) * per_block);
    for (std::size_t q = block * per_block; q < end; ++q) {
      progress.check();
      found[q] = worker->localize(queries[q], scene_limits.empty() ? QueryWorker::all_scenes : scene_limits[q]);
    }
    done += end - block * per_block;
    progress.at(static_cast<double>(done) / static_cast<double>(queries.size()), "recognising places");
  });
  return found;
}

}  // namespace stemwise::treeloc
