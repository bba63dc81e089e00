// From the images of a camera with a lens to those of a pinhole camera in its place.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/lens/lens.h"

namespace fovea {

// Both are of the image's size, and the lens must be of it, too. What the camera sees beyond the
// ideal image is lost: with the same intrinsics that is a margin, of wide fisheyes most. Cost: some
// 30 ns a pixel.
//
// CV_8UC3, interpolated. Where the camera does not see, the colour of its border goes on, so that
// nothing stands out there.
cv::Mat UndistortColor(const cv::Mat& color, const Lens& lens);

// CV_32FC1 of the nearest pixel, never between two surfaces; NaN where the camera does not see.
cv::Mat UndistortDepth(const cv::Mat& depth_m, const Lens& lens);

// CV_8UC1: 255 where the ideal image shows what the camera does not see, else 0. Cost: that of the
// pixels in such margins.
cv::Mat UnseenBy(const Lens& lens);

// The smallest rectangle of the ideal image that holds what is in this one of the sent image, which
// is in it and not empty; what lies beside the ideal image is at its border, and where the lens
// shows nothing a pixel stands for itself. Not empty.
cv::Rect UndistortRect(const Lens& lens, const cv::Rect& sent);

}  // namespace fovea
