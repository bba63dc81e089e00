#include "core/depth/measured_depth.h"

#include <limits>
#include <opencv2/core.hpp>

namespace fovea {

cv::Mat MeasuredDepth(const cv::Mat& depth_m) {
  constexpr double kNearest_m = 1e-3, kFarthest_m = 1e4;
  cv::Mat clean = depth_m.clone();
  const cv::Mat reliable = (depth_m >= kNearest_m) & (depth_m <= kFarthest_m);
  clean.setTo(std::numeric_limits<float>::quiet_NaN(), ~reliable);
  return clean;
}

std::size_t CountMeasured(const cv::Mat& depth_m) {
  return static_cast<std::size_t>(cv::countNonZero(depth_m == depth_m));  // false for NaN
}

std::size_t CountBeyond(const cv::Mat& depth_m, double limit_m) {
  return static_cast<std::size_t>(cv::countNonZero(depth_m > static_cast<float>(limit_m)));
}

cv::Mat ChannelZ(const cv::Mat& points) {
  cv::Mat z;
  cv::extractChannel(points, z, 2);
  return z;
}

}  // namespace fovea
