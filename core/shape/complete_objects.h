// From what was seen of each object to the whole of it: shape and box, and what it stands on.
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "core/depth/back_projection.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// Fills shape, visible_box and what goes with them of each object, completes its box, and says what
// it stands on. `supports`: of each object, the highest that it is above; none: it hangs in the
// air.
//
// An object reaches down to what is below it where that explains its outline at least as well: to
// the top of another object that it is above, or to its support.
void CompleteObjects(const RgbdFrame& frame, const PixelPoints& points,
                     const std::vector<std::optional<SupportSurface>>& supports,
                     Detections& detections);

}  // namespace fovea
