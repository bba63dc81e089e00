// Removes flying pixels: depth that a camera reports in the air between two surfaces where one
// ends in front of the other. Time-of-flight cameras mix both there, stereo's filters smooth over
// it. Goes beyond the paper, whose structured light has a gap there.
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

struct FlyingPixelOptions {
  // Depth that rises or falls on both sides of a pixel as if its surface were seen at more than
  // this angle from its normal is no surface: no camera measures one seen so flatly; degrees, 90
  // removes nothing.
  double max_angle_deg = 80;
};

// Gives every flying pixel the value NaN, along rows and along columns. Single pixels that are
// nearer, or farther, than both their neighbours stay: thin things and noise look like that.
//
// `depth_m`: CV_32FC1, NaN = none; `fx_px`, `fy_px`: focal lengths. Neighbours are a pixel away in
// an image 640 wide and farther in larger ones. Returns the same type and size. Cost: proportional
// to the image.
cv::Mat RemoveFlyingPixels(const cv::Mat& depth_m, double fx_px, double fy_px,
                           const FlyingPixelOptions& options = {});

}  // namespace fovea
