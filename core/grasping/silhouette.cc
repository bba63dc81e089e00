#include "core/grasping/silhouette.h"

#include <algorithm>

#include "core/grasping/solid_line.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

constexpr int kRaysAcross = 32;      // the longer side of the object's bounds
constexpr int kAroundOneIn = 8;      // of its bounds, to each side: a solid may be wider
constexpr float kFarther_m = 0.01F;  // than the solid: more than depth is wrong by

cv::Rect Around(const cv::Rect& bounds) {
  const int x = bounds.width / kAroundOneIn, y = bounds.height / kAroundOneIn;
  return {bounds.x - x, bounds.y - y, bounds.width + 2 * x, bounds.height + 2 * y};
}

float Share(int part, int rest) {
  return part > 0 ? static_cast<float>(part) / static_cast<float>(part + rest) : 0;
}

}  // namespace

Silhouette SilhouetteOf(const GraspScene& scene, const DetectedObject& object) {
  const CompletedSolid solid(object, LevelFrame());  // in the camera's frame
  const cv::Rect looked_at = Around(object.bounds_px) & cv::Rect({}, scene.labels.size());
  const int step =
      std::max(1, std::max(object.bounds_px.width, object.bounds_px.height) / kRaysAcross);
  Lines rays;
  std::vector<float> lengths;
  std::vector<Span> spans;
  int on = 0, through = 0, beside = 0;
  for (int row = looked_at.y; row < looked_at.br().y; row += step) {
    const auto* labels = scene.labels.ptr<std::uint16_t>(row);
    const auto* points = scene.points.ptr<Eigen::Vector3f>(row);
    rays.Clear();
    lengths.clear();
    for (int column = looked_at.x; column < looked_at.br().x; column += step) {
      const Eigen::Vector3f ray = RayOf({column, row}, scene.intrinsics);
      lengths.push_back(ray.norm());
      rays.Add(Eigen::Vector3f::Zero(), ray / lengths.back());
    }
    solid.Along(rays, spans);
    for (std::size_t i = 0; i < spans.size(); ++i) {
      const int column = looked_at.x + static_cast<int>(i) * step;
      const bool is_in = !spans[i].IsEmpty();
      if (labels[column] == object.label) {
        (is_in ? on : beside) += 1;
      } else if (is_in && points[column].z() * lengths[i] > spans[i].low + kFarther_m) {  // not NaN
        ++through;
      }
    }
  }
  return {Share(through, on), Share(beside, on)};
}

}  // namespace fovea
