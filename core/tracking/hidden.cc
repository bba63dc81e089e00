#include "core/tracking/hidden.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "core/depth/measured_depth.h"
#include "core/types/projection.h"

namespace fovea {

HiddenReason ReasonOf(const Sighting& expected, const RgbdFrame& frame) {
  // Beyond the noise of depth, and what was missed of the camera's motion.
  constexpr float kLeast_m = 0.02F, kOfDepth = 0.01F;
  const cv::Rect2d image(-0.5, -0.5, frame.depth_m.cols, frame.depth_m.rows);
  std::size_t covered = 0, outside = 0, gone = 0;
  for (const Eigen::Vector3f& point : expected.points) {
    const bool is_ahead = point.z() > 0;
    const cv::Point2d pixel = is_ahead ? Project(point, frame.intrinsics) : cv::Point2d(-1, -1);
    if (!image.contains(pixel)) {
      ++outside;
      continue;
    }
    const float seen_m = frame.depth_m.at<float>(cvRound(pixel.y), cvRound(pixel.x));
    if (!IsMeasured(seen_m)) continue;
    const float behind_m = seen_m - point.z();
    const float margin_m = kLeast_m + kOfDepth * point.z();
    if (behind_m < -margin_m) ++covered;
    if (behind_m > margin_m) ++gone;
  }
  const std::size_t half = expected.points.size() / 2;
  if (outside > half) return HiddenReason::kOutOfView;
  if (covered > half) return HiddenReason::kCovered;
  if (gone > half) return HiddenReason::kGone;
  return HiddenReason::kNotDetected;
}

}  // namespace fovea
