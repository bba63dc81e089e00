// Generated frames beside what was found in them.
#pragma once

#include "core/types/detections.h"
#include "tests/evaluation/tracking/track_scores.h"
#include "tests/support/labelled_frame.h"

namespace fovea::evaluation {

// Things of which fewer pixels with depth are seen do not count, nor what is found on them.
constexpr int kFewestPixels = 300;

// The truth as an answer: masks where there is depth, and boxes of the visible points along the
// camera's axes.
Detections TrueDetections(const scenes::LabelledFrame& truth);

// `found`: with tracks. Things are numbered by their labels.
TrackFrame Compare(const scenes::LabelledFrame& truth, const Detections& found);

}  // namespace fovea::evaluation
