#include "client/cli/cloud.h"

#include <opencv2/core.hpp>
#include <stdexcept>

#include "client/cli/labels.h"
#include "client/cli/overlay/palette.h"

namespace fovea::cli {
namespace {

// Half true colour and half the object's; the background loses a third of its light.
cv::Vec3b Shade(const cv::Vec3b& bgr, std::uint32_t label) {
  if (label == 0) return bgr * 0.65;
  const cv::Scalar tint = ColorOf(label);
  return cv::Vec3b(cv::saturate_cast<std::uint8_t>(0.5 * bgr[0] + 0.5 * tint[0]),
                   cv::saturate_cast<std::uint8_t>(0.5 * bgr[1] + 0.5 * tint[1]),
                   cv::saturate_cast<std::uint8_t>(0.5 * bgr[2] + 0.5 * tint[2]));
}

}  // namespace

std::vector<CloudPoint> TintedCloud(const cv::Mat& color, const std::vector<DepthPoint>& points,
                                    const v1::Detections& detections) {
  cv::Mat labels;
  LabelImage(detections).convertTo(labels, CV_16U);
  if (color.size() != labels.size()) throw std::runtime_error("colour and labels differ in size");
  std::vector<CloudPoint> cloud;
  cloud.reserve(points.size());
  for (const auto& [position, pixel] : points) {
    cloud.push_back(
        {cv::Vec3f(position), Shade(color.at<cv::Vec3b>(pixel), labels.at<std::uint16_t>(pixel))});
  }
  return cloud;
}

}  // namespace fovea::cli
