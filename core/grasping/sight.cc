#include "core/grasping/sight.h"

#include <cmath>

#include "core/types/projection.h"

namespace fovea {

namespace {

// `depth_at`: of a row and column, metres, NaN = none.
template <typename DepthAt>
Sight SightBy(const DepthAt& depth_at, const GraspScene& scene, int label,
              const Eigen::Vector3f& place) {
  constexpr float kTolerance_m = 0.008F, kTolerancePer_m = 0.004F;
  constexpr float kNearest_m = 0.01F;
  if (place.z() < kNearest_m) return Sight::kOutsideOfImage;
  const cv::Point2d at = Project(place, scene.intrinsics);
  if (!(at.x > -0.5 && at.y > -0.5 && at.x < scene.labels.cols - 0.5 &&
        at.y < scene.labels.rows - 0.5)) {
    return Sight::kOutsideOfImage;
  }
  const int row = static_cast<int>(std::lround(at.y)), column = static_cast<int>(std::lround(at.x));
  const float seen_m = depth_at(row, column);
  if (std::isnan(seen_m)) return Sight::kUnmeasured;
  const bool is_target = scene.labels.ptr<std::uint16_t>(row)[column] == label;
  const float tolerance = kTolerance_m + kTolerancePer_m * place.z() * place.z();
  if (seen_m < place.z() - tolerance) {
    return is_target ? Sight::kBehindTarget : Sight::kBehindOther;
  }
  return is_target && seen_m < place.z() + tolerance ? Sight::kOnTarget : Sight::kFree;
}

}  // namespace

Sight SightOf(const GraspScene& scene, int label, const Eigen::Vector3f& place) {
  const auto depth_at = [&](int row, int column) {
    return scene.points.ptr<cv::Vec3f>(row)[column][2];
  };
  return SightBy(depth_at, scene, label, place);
}

Sight MeasuredSightOf(const GraspScene& scene, int label, const Eigen::Vector3f& place) {
  if (scene.measured_m.empty()) return SightOf(scene, label, place);
  const auto depth_at = [&](int row, int column) {
    return scene.measured_m.ptr<float>(row)[column];
  };
  return SightBy(depth_at, scene, label, place);
}

bool IsAtMask(const GraspScene& scene, int row, int column, int label) {
  constexpr int kAway_px = 2;
  const auto is_label = [&](int r, int c) {
    return r >= 0 && c >= 0 && r < scene.labels.rows && c < scene.labels.cols &&
           scene.labels.ptr<std::uint16_t>(r)[c] == label;
  };
  return is_label(row, column - kAway_px) || is_label(row, column + kAway_px) ||
         is_label(row - kAway_px, column) || is_label(row + kAway_px, column);
}

}  // namespace fovea
