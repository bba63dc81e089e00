// Lengths in the image.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

namespace fovea {

// A length given in pixels of an image 640 wide, what most depth cameras have, in pixels of an
// image of another width.
inline int ScaledPx(double px_at_640, int width_px, int least_px) {
  return std::max(least_px, cvRound(px_at_640 * width_px / 640));
}

}  // namespace fovea
