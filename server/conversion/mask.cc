#include "server/conversion/mask.h"

namespace fovea::server {

v1::BoundingBox2D ToProto(const cv::Rect& bounds) {
  v1::BoundingBox2D proto;
  proto.set_x(static_cast<std::uint32_t>(bounds.x));
  proto.set_y(static_cast<std::uint32_t>(bounds.y));
  proto.set_width(static_cast<std::uint32_t>(bounds.width));
  proto.set_height(static_cast<std::uint32_t>(bounds.height));
  return proto;
}

v1::Mask MaskToProto(const cv::Mat& labels, int label, const cv::Rect& bounds) {
  v1::Mask mask;
  *mask.mutable_bounds() = ToProto(bounds);
  bool inside = false;  // runs begin with background, which may be 0 long
  std::uint32_t length = 0;
  for (int y = bounds.y; y < bounds.y + bounds.height; ++y) {
    const auto* row = labels.ptr<std::uint16_t>(y);
    for (int x = bounds.x; x < bounds.x + bounds.width; ++x) {
      if ((row[x] == label) != inside) {
        mask.add_runs(length);
        length = 0;
        inside = !inside;
      }
      ++length;
    }
  }
  if (length > 0) mask.add_runs(length);
  return mask;
}

}  // namespace fovea::server
