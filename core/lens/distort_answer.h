// What was found in the images of a pinhole camera, in the pixels that were sent.
#pragma once

#include "core/lens/lens.h"
#include "core/trace.h"
#include "core/types/detections.h"

namespace fovea {

// Turns the pixels of an answer (labels, rectangles, numbers of pixels, the cloud's point for each
// pixel, seeds, and the images of `trace`) into those that the lens shows them at. A pixel has the
// label of the ideal pixel nearest to what it sees, 0 where that is outside of the ideal image.
// Centroids and colours are those of the new cloud. An object that no pixel shows keeps a
// rectangle, and these. Other positions stay as they are. Cost: some 0.5 µs for each pixel that is
// in any of the rectangles, and of the image where there is a trace.
void DistortAnswer(const Lens& lens, Detections& detections, Trace& trace);

}  // namespace fovea
