// Lenses of images of 160 x 120 pixels.
#pragma once

#include <opencv2/core/types.hpp>

#include "core/lens/lens.h"

namespace fovea::testing {

const cv::Size kSize(160, 120);

// Bends the corners inwards by some eight pixels.
inline Lens Barrel() {
  return {{130, 130, 79.5, 59.5},
          {LensDistortion::Model::kBrownConrady, {-0.15, 0.01, 0.001, 0.002}},
          kSize};
}

// Its corners see less than those of the ideal image.
inline Lens Cushion() {
  return {{130, 130, 79.5, 59.5}, {LensDistortion::Model::kBrownConrady, {0.3}}, kSize};
}

}  // namespace fovea::testing
