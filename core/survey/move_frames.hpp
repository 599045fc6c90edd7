#pragma once
#include "core/forest/frame_set.hpp"

namespace stemwise {

/// The same survey told in another frame of reference: poses premultiplied, frames unchanged.
FrameSet move_frames(FrameSet frames, const RigidTransform& moved_from_survey);

}  // namespace stemwise
