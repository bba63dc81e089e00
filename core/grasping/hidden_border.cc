#include "core/grasping/hidden_border.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fovea {
namespace {

constexpr int kBeyond_px = 4;  // depth next to an edge may be of either side

// Noise grows with the square of the distance (Khoshelham and Elberink 2012); what is nearer by
// more than this is something else.
constexpr float kNearerPerM = 0.015F;

}  // namespace

float HiddenShareOfBorder(const GraspScene& scene, const DetectedObject& object) {
  constexpr std::array<std::array<int, 2>, 4> kWays = {{{0, 1}, {0, -1}, {1, 0}, {-1, 0}}};
  const cv::Rect image({}, scene.labels.size());
  const cv::Rect bounds = object.bounds_px & image;
  const auto label_at = [&](int row, int column) {
    return image.contains({column, row}) ? scene.labels.ptr<std::uint16_t>(row)[column] : -1;
  };
  int hidden = 0, all = 0;
  for (int row = bounds.y; row < bounds.br().y; ++row) {
    for (int column = bounds.x; column < bounds.br().x; ++column) {
      if (label_at(row, column) != object.label) continue;
      const float depth = scene.points.ptr<cv::Vec3f>(row)[column][2];
      for (const auto& [down, right] : kWays) {
        if (label_at(row + down, column + right) == object.label) continue;
        ++all;
        const cv::Point beyond(column + kBeyond_px * right, row + kBeyond_px * down);
        if (!image.contains(beyond)) {
          ++hidden;
          continue;
        }
        const float depth_beyond = scene.points.at<cv::Vec3f>(beyond)[2];
        hidden += depth_beyond < depth - kNearerPerM * std::max(0.5F, depth * depth) ? 1 : 0;
      }
    }
  }
  return all > 0 ? static_cast<float>(hidden) / static_cast<float>(all) : 1;
}

}  // namespace fovea
