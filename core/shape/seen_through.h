// Where a solid cannot be, since what lies behind it is seen.
#pragma once

#include <opencv2/core/types.hpp>

#include "core/shape/shape_fit.h"

namespace fovea {

// Of the surface of a solid towards the camera, as large as it looks, the share in whose place
// something farther away is seen that is not the object. 0 … 1. What its mask has close by or on
// all four sides is the object all the same: depth and mask may be off there, and the bottom of a
// bowl may be taken for what it stands on. `bounds`: of the object with label `label`. Cost: some
// 200 looks at the images, and a look at the bounds for each that something else is seen at.
float SeenThroughShare(const SeenScene& scene, int label, const cv::Rect& bounds,
                       const Solid& solid, const LevelFrame& frame);

}  // namespace fovea
