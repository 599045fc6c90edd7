#pragma once
#include <string>
#include <vector>

#include "core/forest/frame_set.hpp"
#include "core/treeloc/settings.hpp"

namespace stemwise::benchmarks {

/// Two surveys of one forest: what is measured. Folders are empty for a synthetic pair.
struct Sequences {
  std::string query_folder, map_folder;
  FrameSet query, map;
};

/// venman-03 (queries) and venman-04 (map) from $STEMWISE_SHARED_DATA, else a synthetic pair of about their size.
Sequences load_sequences();

/// The first `most` frames of a walk through a synthetic stand that has room for `frames`. `seed` is that of the sensor's noise:
/// the stand is the same.
FrameSet synthetic_frames(std::size_t frames, std::uint64_t seed, std::size_t most);

}  // namespace stemwise::benchmarks
