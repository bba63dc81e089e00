#include "core/depth/depth_view.h"

#include <cmath>
#include <cstdint>

#include "core/types/interruption.h"

namespace fovea {
namespace {

class DepthView {
 public:
  DepthView(const CameraIntrinsics& color, const Eigen::Isometry3d& color_from_depth,
            const CameraIntrinsics& depth, const cv::Size& depth_size)
      : color_(color),
        depth_(depth),
        depth_from_color_(color_from_depth.inverse()),
        size_(depth_size) {}

  // Of a pixel of colour, whether the depth image shows what is there at this depth.
  bool Shows(const cv::Point& pixel, double z) const {
    const Eigen::Vector3d ray((pixel.x - color_.cx_px) / color_.fx_px,
                              (pixel.y - color_.cy_px) / color_.fy_px, 1);
    const Eigen::Vector3d point = depth_from_color_ * (z * ray);
    if (point.z() <= 0) return false;
    const double x = point.x() / point.z() * depth_.fx_px + depth_.cx_px;
    const double y = point.y() / point.z() * depth_.fy_px + depth_.cy_px;
    return x >= -0.5 && y >= -0.5 && x <= size_.width - 0.5 && y <= size_.height - 0.5;
  }

 private:
  CameraIntrinsics color_, depth_;
  Eigen::Isometry3d depth_from_color_;
  cv::Size size_;
};

// Along one line of `num` pixels, from its end at `first` on.
void MarkUnseen(const cv::Mat& registered_m, const DepthView& view, const cv::Point& first,
                const cv::Point& step, int num, cv::Mat& unseen) {
  int margin = 0;
  while (margin < num && std::isnan(registered_m.at<float>(first + margin * step))) ++margin;
  if (margin == num) return;
  const double z = registered_m.at<float>(first + margin * step);
  for (int i = 0; i < margin; ++i) {
    const cv::Point pixel = first + i * step;
    if (!view.Shows(pixel, z)) unseen.at<std::uint8_t>(pixel) = 255;
  }
}

}  // namespace

cv::Mat UnseenByDepthCamera(const cv::Mat& registered_m, const CameraIntrinsics& color,
                            const Eigen::Isometry3d& color_from_depth,
                            const CameraIntrinsics& depth, const cv::Size& depth_size) {
  const DepthView view(color, color_from_depth, depth, depth_size);
  cv::Mat unseen = cv::Mat::zeros(registered_m.size(), CV_8UC1);
  const auto mark = [&](const cv::Point& first, const cv::Point& step, int num) {
    MarkUnseen(registered_m, view, first, step, num, unseen);
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
