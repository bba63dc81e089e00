// The method as Bao et al. 2015 describe it, step by step: profile "paper".
#pragma once

#include "core/paper/paper_options.h"
#include "core/stage_clock.h"
#include "core/trace.h"
#include "core/types/detections.h"
#include "core/types/gripper.h"
#include "core/types/rgbd_frame.h"

namespace fovea::paper {

// Fills `result` with the objects of a valid frame and how the grippers take them, and `trace`, if
// given, with the steps between (paper sections 3.1 to 3.3). The first stage of `clock` has begun.
// Errors as of fovea::Detect.
void FindObjects(const RgbdFrame& frame, const PaperOptions& options,
                 const std::vector<Gripper>& grippers, Trace* trace, StageClock& clock,
                 Detections& result);

}  // namespace fovea::paper
