// The method as Bao et al. 2015 describe it, step by step: profile "paper".
#pragma once

#include "core/object_surroundings.h"
#include "core/paper/paper_options.h"
#include "core/stage_clock.h"
#include "core/trace.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea::paper {

// Fills `result` with the objects of a valid frame, of depth as of MeasuredDepth, and `trace`, if
// given, with the steps between (paper sections 3.1 to 3.3). Returns what the objects stand in. The
// first stage of `clock` has begun. Errors as of fovea::Detect.
ObjectSurroundings FindObjects(const RgbdFrame& frame, const PaperOptions& options, Trace* trace,
                               StageClock& clock, Detections& result);

}  // namespace fovea::paper
