// The depth of a frame as the stages rely on it.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>

namespace fovea {

// What is nearer or farther no camera measures.
inline constexpr float kNearestMeasured_m = 1e-3F, kFarthestMeasured_m = 1e4F;
inline bool IsMeasured(float depth_m) {
  return depth_m >= kNearestMeasured_m && depth_m <= kFarthestMeasured_m;
}

// A copy in which every value that is not measured is NaN. `depth_m`: CV_32FC1, metres.
cv::Mat MeasuredDepth(const cv::Mat& depth_m);

// Number of values that are not NaN. `depth_m`: CV_32FC1.
std::size_t CountMeasured(const cv::Mat& depth_m);

// Number of them up to `limit_m`.
std::size_t CountUpTo(const cv::Mat& depth_m, double limit_m);

// A copy in which values beyond `limit_m` are NaN too. `depth_m`: CV_32FC1, NaN = none.
cv::Mat DepthUpTo(const cv::Mat& depth_m, double limit_m);

// The z coordinates of CV_32FC3 points.
cv::Mat ChannelZ(const cv::Mat& points);

}  // namespace fovea
