// The map that depth saliency works on.
#pragma once

#include <limits>
#include <opencv2/core/mat.hpp>

namespace fovea {

// Stands for "no depth" in a map of nearness: never the least value along a line.
inline constexpr float kNoNearness = std::numeric_limits<float>::infinity();

// 1/depth in 1/m, smoothed by a Gaussian of 7×7 pixels with σ = 1.75 px over the neighbours that
// have depth. Ju's maps are stereo disparities, which are proportional to it.
//
// `depth_m`: CV_32FC1; NaN, infinite or not positive = none. Returns CV_32FC1 of its size,
// kNoNearness where there is no depth. The same bits on any machine, unlike cv::GaussianBlur.
cv::Mat SmoothNearness(const cv::Mat& depth_m);

}  // namespace fovea
