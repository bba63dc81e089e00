#include "core/depth/measured_depth.h"

#include <limits>
#include <opencv2/core.hpp>

#include "core/types/widest_registers.h"

namespace fovea {
namespace {

// A copy in which what does not lie between the two is NaN.
cv::Mat DepthWithin(const cv::Mat& depth_m, float nearest_m, float farthest_m) {
  cv::Mat within(depth_m.size(), CV_32FC1);
  for (int row = 0; row < depth_m.rows; ++row) {
    const float* depth = depth_m.ptr<float>(row);
    float* out = within.ptr<float>(row);
    RunInWidestRegisters([=, cols = depth_m.cols] {
      for (int col = 0; col < cols; ++col) {
        const bool is_within = (depth[col] >= nearest_m) & (depth[col] <= farthest_m);
        out[col] = is_within ? depth[col] : std::numeric_limits<float>::quiet_NaN();
      }
    });
  }
  return within;
}

}  // namespace

cv::Mat MeasuredDepth(const cv::Mat& depth_m) {
  return DepthWithin(depth_m, kNearestMeasured_m, kFarthestMeasured_m);
}

cv::Mat DepthUpTo(const cv::Mat& depth_m, double limit_m) {
  return DepthWithin(depth_m, -std::numeric_limits<float>::infinity(), static_cast<float>(limit_m));
}

std::size_t CountUpTo(const cv::Mat& depth_m, double limit_m) {
  const auto limit = static_cast<float>(limit_m);
  std::size_t count = 0;
  for (int row = 0; row < depth_m.rows; ++row) {
    const float* depth = depth_m.ptr<float>(row);
    RunInWidestRegisters([&, cols = depth_m.cols] {
      int in_row = 0;
      for (int col = 0; col < cols; ++col) in_row += depth[col] <= limit ? 1 : 0;
      count += static_cast<std::size_t>(in_row);
    });
  }
  return count;
}

std::size_t CountMeasured(const cv::Mat& depth_m) {
  return CountUpTo(depth_m, std::numeric_limits<double>::infinity());
}

cv::Mat ChannelZ(const cv::Mat& points) {
  cv::Mat z;
  cv::extractChannel(points, z, 2);
  return z;
}

}  // namespace fovea
