#include "core/grasping/hidden_border.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

constexpr int kBeyond_px = 4;  // depth next to an edge may be of either side

// Noise grows with the square of the distance (Khoshelham and Elberink 2012); what is nearer by
// more than this is something else.
constexpr float kNearerPerM = 0.015F;

struct Border {
  int hidden = 0, all = 0;

  // One pixel of it, and the way out.
  void Add(const cv::Mat& points, int row, int column, int down, int right) {
    ++all;
    const cv::Point beyond(column + kBeyond_px * right, row + kBeyond_px * down);
    if (!cv::Rect({}, points.size()).contains(beyond)) {
      ++hidden;
      return;
    }
    const float depth = points.ptr<cv::Vec3f>(row)[column][2];
    const float depth_beyond = points.ptr<cv::Vec3f>(beyond.y)[beyond.x][2];
    hidden += depth_beyond < depth - kNearerPerM * std::max(0.5F, depth * depth) ? 1 : 0;
  }
};

}  // namespace

float HiddenShareOfBorder(const GraspScene& scene, const DetectedObject& object) {
  const cv::Mat& labels = scene.labels;
  const cv::Rect bounds = object.bounds_px & cv::Rect({}, labels.size());
  const auto row_at = [&](int row) {
    return row < 0 || row >= labels.rows ? nullptr : labels.ptr<std::uint16_t>(row);
  };
  const auto is_of_it = [&](const std::uint16_t* row, int column) {
    return row != nullptr && column >= 0 && column < labels.cols && row[column] == object.label;
  };
  Border border;
  for (int row = bounds.y; row < bounds.br().y; ++row) {
    const std::uint16_t *above = row_at(row - 1), *here = row_at(row), *below = row_at(row + 1);
    for (int column = bounds.x; column < bounds.br().x; ++column) {
      if (here[column] != object.label) continue;
      if (!is_of_it(here, column + 1)) border.Add(scene.points, row, column, 0, 1);
      if (!is_of_it(here, column - 1)) border.Add(scene.points, row, column, 0, -1);
      if (!is_of_it(below, column)) border.Add(scene.points, row, column, 1, 0);
      if (!is_of_it(above, column)) border.Add(scene.points, row, column, -1, 0);
    }
  }
  return border.all > 0 ? static_cast<float>(border.hidden) / static_cast<float>(border.all) : 1;
}

}  // namespace fovea
