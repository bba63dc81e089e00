#include "core/depth/depth_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/types/interruption.h"

namespace fovea {
namespace {

class LineOfSight {
 public:
  LineOfSight(const CameraIntrinsics& color, const DepthView& depth)
      : color_(color), depth_(depth), depth_from_color_(depth.color_from_depth.inverse()) {}

  // Of a pixel of colour, whether the depth camera shows what is there at this depth.
  bool IsShown(const cv::Point& pixel, double z) const {
    const Eigen::Vector3d ray((pixel.x - color_.cx_px) / color_.fx_px,
                              (pixel.y - color_.cy_px) / color_.fy_px, 1);
    const Eigen::Vector3d point = depth_from_color_ * (z * ray);
    if (point.z() <= 0) return false;
    const CameraIntrinsics& k = depth_.intrinsics;
    const double x = point.x() / point.z() * k.fx_px + k.cx_px;
    const double y = point.y() / point.z() * k.fy_px + k.cy_px;
    const cv::Size& size = depth_.size;
    const bool is_inside =
        x >= -0.5 && y >= -0.5 && x <= size.width - 0.5 && y <= size.height - 0.5;
    if (!is_inside || depth_.unseen.empty()) return is_inside;
    const int col = std::clamp(cvRound(x), 0, size.width - 1);
    const int row = std::clamp(cvRound(y), 0, size.height - 1);
    return depth_.unseen.at<std::uint8_t>(row, col) == 0;
  }

 private:
  const CameraIntrinsics& color_;
  const DepthView& depth_;
  Eigen::Isometry3d depth_from_color_;
};

// Along one line of `num` pixels, from its end at `first` on.
void MarkUnseen(const cv::Mat& registered_m, const LineOfSight& sight, const cv::Point& first,
                const cv::Point& step, int num, cv::Mat& unseen) {
  int margin = 0;
  while (margin < num && std::isnan(registered_m.at<float>(first + margin * step))) ++margin;
  if (margin == num) return;
  const double z = registered_m.at<float>(first + margin * step);
  for (int i = 0; i < margin; ++i) {
    const cv::Point pixel = first + i * step;
    if (!sight.IsShown(pixel, z)) unseen.at<std::uint8_t>(pixel) = 255;
  }
}

}  // namespace

cv::Mat UnseenByDepthCamera(const cv::Mat& registered_m, const CameraIntrinsics& color,
                            const DepthView& depth) {
  const LineOfSight sight(color, depth);
  cv::Mat unseen = cv::Mat::zeros(registered_m.size(), CV_8UC1);
  const auto mark = [&](const cv::Point& first, const cv::Point& step, int num) {
    MarkUnseen(registered_m, sight, first, step, num, unseen);
  };
  const int cols = registered_m.cols, rows = registered_m.rows;
  for (int row = 0; row < rows; ++row) {
    InterruptionPoint();
    mark({0, row}, {1, 0}, cols);
    mark({cols - 1, row}, {-1, 0}, cols);
  }
  for (int col = 0; col < cols; ++col) {
    InterruptionPoint();
    mark({col, 0}, {0, 1}, rows);
    mark({col, rows - 1}, {0, -1}, rows);
  }
  return unseen;
}

}  // namespace fovea
