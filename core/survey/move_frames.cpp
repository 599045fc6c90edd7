#include "core/survey/move_frames.hpp"

namespace stemwise {

FrameSet move_frames(FrameSet frames, const RigidTransform& moved_from_survey) {
  for (Frame& frame : frames.frames) frame.pose.survey_from_frame = moved_from_survey * frame.pose.survey_from_frame;
  return frames;
}

}  // namespace stemwise
