// A table to put things on.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "core/relations/free_places.h"

namespace fovea {

inline constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// A camera 1 m above a table of 1 m by 0.6 m, looking straight down: a pixel is 4 mm.
struct Table {
  float pixel_m;
  cv::Mat points;
  RgbdFrame frame;
  cv::Mat labels;
  std::vector<Support> supports{{{-Eigen::Vector3f::UnitZ(), 1, 1000}, Footprint(), 1}};

  explicit Table(int pixels_per_m = 250)
      : pixel_m(1 / static_cast<float>(pixels_per_m)),
        points(pixels_per_m * 24 / 25, pixels_per_m * 32 / 25, CV_32FC3, cv::Scalar::all(kNone)),
        labels(cv::Mat::zeros(points.size(), CV_16UC1)) {
    const cv::Point middle = cv::Point(points.size()) / 2;
    frame.intrinsics = {1.0 * pixels_per_m, 1.0 * pixels_per_m, 1.0 * middle.x, 1.0 * middle.y};
    Put({-0.5F, -0.3F}, {0.5F, 0.3F}, 0);
  }
  void Put(const Eigen::Vector2f& low, const Eigen::Vector2f& high, float height_m, int label = 0) {
    ForEach([&](const Eigen::Vector2f& at, const cv::Point& pixel) {
      if ((at - low).minCoeff() < 0 || (high - at).minCoeff() < 0) return;
      points.at<cv::Vec3f>(pixel) = {at.x(), at.y(), 1 - height_m};
      labels.at<std::uint16_t>(pixel) = static_cast<std::uint16_t>(label);
    });
  }
  // Calls `what` with the place on the table and the pixel.
  void ForEach(const auto& what) {
    for (int row = 0; row < points.rows; ++row) {
      for (int col = 0; col < points.cols; ++col) {
        what(pixel_m * Eigen::Vector2f(static_cast<float>(col - points.cols / 2),
                                       static_cast<float>(row - points.rows / 2)),
             cv::Point(col, row));
      }
    }
  }
  std::vector<FreePlace> Places(const PlaceOptions& options,
                                const std::vector<DetectedObject>& objects = {},
                                const SupportOptions& support = {.tolerance_m = 0.004}) {
    if (frame.depth_m.empty()) cv::extractChannel(points, frame.depth_m, 2);
    return FindFreePlaces({frame, points, labels}, supports, objects, options, support);
  }
};

// Upright, around a place on the table.
inline DetectedObject Thing(const Eigen::Vector2f& at, const Eigen::Vector3f& size_m) {
  DetectedObject object;
  object.box.center = {at.x(), at.y(), 1 - size_m.z() / 2};
  object.box.rotation << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  object.box.size_m = size_m;
  return object;
}

}  // namespace fovea
