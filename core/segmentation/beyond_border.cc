#include "core/segmentation/beyond_border.h"

#include <cstdint>
#include <limits>

#include "core/types/pixels.h"

namespace fovea {
namespace {

constexpr double kReachPx = 30;
constexpr int kLeastReachPx = 4;

}  // namespace

std::optional<float> DepthBeyond(const cv::Mat& labels, const cv::Mat& depth_m,
                                 const cv::Point& pixel, const cv::Point2f& direction,
                                 int edge_px) {
  const cv::Rect image({}, labels.size());
  const std::uint16_t label = labels.at<std::uint16_t>(pixel);
  const int reach_px = ScaledPx(kReachPx, labels.cols, kLeastReachPx);
  for (int step = 1; step <= reach_px; ++step) {
    const cv::Point beyond(cvRound(static_cast<float>(pixel.x) + step * direction.x),
                           cvRound(static_cast<float>(pixel.y) + step * direction.y));
    if (!image.contains(beyond)) break;
    if (labels.at<std::uint16_t>(beyond) == label) return std::nullopt;
    const float z = depth_m.at<float>(beyond);
    if (step > edge_px && z > 0) return z;
  }
  return std::numeric_limits<float>::quiet_NaN();
}

}  // namespace fovea
