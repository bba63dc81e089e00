// Runs a detector over boxed frames and scores it.
#pragma once

#include <functional>
#include <vector>

#include "core/types/detections.h"
#include "tests/evaluation/real_frames/box_report.h"
#include "tests/evaluation/real_frames/boxed_frames.h"

namespace fovea::evaluation {

using DetectInFrame = std::function<Detections(const RgbdFrame&)>;

// Called once per frame, one call at a time, from the thread that ran it.
using BoxedFrameDone = std::function<void(const BoxedFrame&, const Detections&)>;

// Results come in the order of `frames`, of which `num_threads` are detected at a time. Throws what
// `detect` throws.
std::vector<BoxedFrameResult> RunBoxedFrames(const std::vector<BoxedFrame>& frames,
                                             const DetectInFrame& detect, int num_threads,
                                             const BoxedFrameDone& done = {});

}  // namespace fovea::evaluation
