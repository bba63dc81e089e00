// Lengths and areas in the image.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

namespace fovea {

// A length given in pixels of an image 640 wide, what most depth cameras have, in pixels of an
// image of another width.
inline int ScaledPx(double px_at_640, int width_px, int least_px) {
  return std::max(least_px, cvRound(px_at_640 * width_px / 640));
}

// Even in a tiny image, an object has more pixels than noise does.
constexpr int kFewestPixels = 20;

// The area of an image in images of 640×480.
inline double AreaScale(const cv::Size& image) {
  return static_cast<double>(image.area()) / (640.0 * 480.0);
}

}  // namespace fovea
