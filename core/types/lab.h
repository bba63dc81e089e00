// CIELAB, in which distances of colours are near to what people see.
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

// `color_rgb`: CV_8UC3, R first, not empty. Returns CV_8UC3 of the same size as OpenCV scales it:
// L from 0 … 100 to 0 … 255, a and b moved by 128. May be called by several threads at once, unlike
// the first cv::cvtColor to Lab of OpenCV before 4.9.
cv::Mat LabOf(const cv::Mat& color_rgb);

}  // namespace fovea
