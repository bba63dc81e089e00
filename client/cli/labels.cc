#include "client/cli/labels.h"

#include <stdexcept>

#include "client/mask.h"

namespace fovea::cli {

cv::Mat MaskImage(const v1::Object& object) {
  std::vector<std::uint8_t> pixels = client::DecodeMask(object.mask());
  const auto& bounds = object.mask().bounds();
  const cv::Mat mask(static_cast<int>(bounds.height()), static_cast<int>(bounds.width()), CV_8UC1,
                     pixels.data());
  return mask * 255;
}

cv::Rect BoundsOf(const v1::BoundingBox2D& bounds, const cv::Size& frame) {
  const std::uint64_t right = std::uint64_t{bounds.x()} + bounds.width();
  const std::uint64_t bottom = std::uint64_t{bounds.y()} + bounds.height();
  if (right > static_cast<std::uint64_t>(frame.width) ||
      bottom > static_cast<std::uint64_t>(frame.height)) {
    throw std::runtime_error("the server's answer has an object outside of the image");
  }
  return {static_cast<int>(bounds.x()), static_cast<int>(bounds.y()),
          static_cast<int>(bounds.width()), static_cast<int>(bounds.height())};
}

cv::Mat LabelImage(const v1::Detections& detections) {
  const cv::Size size(static_cast<int>(detections.width()), static_cast<int>(detections.height()));
  const int type = detections.objects_size() <= 255 ? CV_8UC1 : CV_16UC1;
  cv::Mat labels = cv::Mat::zeros(size, type);
  for (const v1::Object& object : detections.objects()) {
    labels(BoundsOf(object.mask().bounds(), size)).setTo(object.label(), MaskImage(object));
  }
  return labels;
}

}  // namespace fovea::cli
