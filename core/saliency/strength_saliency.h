// Colour saliency by strength propagation (Bao et al. 2015, section 3.1, Algorithm 1).
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

struct StrengthSaliencyOptions {
  // Neighbourhood rings s = 1 … num_scales; 1 … 8. Paper: 4.
  int num_scales = 4;
  // The image is reduced by this factor (area average) first and the map enlarged afterwards
  // (nearest neighbour, which keeps plateaus flat); 1 … 8. Paper: 1.
  int downscale = 1;
  // MaxDist of Eq. 3, "the maximum distance between any two feature vectors in the feature space":
  // false: of the 8-bit channel, 255; true: of the values that the image has in it.
  bool stretch = false;
};

// The strength S of each pixel of one feature channel at one scale: pixels within `scale` of an
// image border have strength 1; every other pixel takes the maximum over the 8·scale pixels at
// Chebyshev distance `scale` of S(neighbour) · (1 − |difference| / 255), Eq. 3 and 4, at the exact
// fixed point.
//
// `channel`: CV_8UC1, not empty. Returns CV_32FC1 of its size, values in [0, 1].
cv::Mat PropagateStrength(const cv::Mat& channel, int scale);

// Algorithm 1: the sum of 1 − S over the scales and the CIELAB channels (8 bits each), divided by
// its L2 norm (unchanged where that is 0). With `downscale` that of the reduced image, in flat
// blocks.
//
// `color_rgb`: CV_8UC3, R first, not empty. Returns CV_32FC1 of its size, larger = more salient.
cv::Mat StrengthSaliency(const cv::Mat& color_rgb, const StrengthSaliencyOptions& options = {});

}  // namespace fovea
