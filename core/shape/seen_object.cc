#include "core/shape/seen_object.h"

#include <algorithm>

namespace fovea {
namespace {

constexpr std::size_t kMaxPoints = 160, kMaxRays = 80;

// Depth noise as cameras of this class have it, of structured light and stereo alike (Khoshelham
// and Elberink 2012); and of an outline, in pixels. They say what counts for more, no more.
constexpr float kNoise_m = 0.002F, kNoisePerM = 0.0024F;
constexpr float kOutlineNoise_px = 1.25F, kOutlineNoise_m = 0.001F;

void SetPoint(LevelPoints& points, Eigen::Index i, const Eigen::Vector3f& p) {
  points.x[i] = p.x();
  points.y[i] = p.y();
  points.h[i] = p.z();
}

void AddPoints(const std::vector<ColoredPoint>& cloud, const LevelFrame& frame, SeenObject& seen) {
  const std::size_t count = std::min(cloud.size(), kMaxPoints);
  seen.points = LevelPoints(static_cast<Eigen::Index>(count));
  seen.noise_m.resize(static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const ColoredPoint& p = cloud[i * cloud.size() / count];
    const auto row = static_cast<Eigen::Index>(i);
    SetPoint(seen.points, row, frame.FromCamera({p.x, p.y, p.z}));
    seen.noise_m[row] = kNoise_m + kNoisePerM * p.z * p.z;
  }
}

void AddOutline(const std::vector<OutlinePoint>& outline, const CameraIntrinsics& intrinsics,
                const LevelFrame& frame, float depth_m, SeenObject& seen) {
  const std::size_t count = std::min(outline.size(), kMaxRays);
  seen.directions = LevelPoints(static_cast<Eigen::Index>(count));
  seen.is_own_end.resize(static_cast<Eigen::Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const OutlinePoint& point = outline[i * outline.size() / count];
    const Eigen::Vector3f ray((point.pixel.x() - static_cast<float>(intrinsics.cx_px)) /
                                  static_cast<float>(intrinsics.fx_px),
                              (point.pixel.y() - static_cast<float>(intrinsics.cy_px)) /
                                  static_cast<float>(intrinsics.fy_px),
                              1);
    const auto row = static_cast<Eigen::Index>(i);
    SetPoint(seen.directions, row, frame.rotation.transpose() * ray);
    seen.is_own_end[row] = point.is_own_end ? 1 : 0;
  }
  seen.outline_noise_m = SeenArray::Constant(
      static_cast<Eigen::Index>(count),
      kOutlineNoise_px * depth_m / static_cast<float>(intrinsics.fx_px) + kOutlineNoise_m);
}

}  // namespace

SeenObject See(const DetectedObject& object, const std::vector<OutlinePoint>& outline,
               const CameraIntrinsics& intrinsics, const LevelFrame& frame) {
  SeenObject seen;
  seen.camera = frame.FromCamera(Eigen::Vector3f::Zero());
  AddPoints(object.cloud, frame, seen);
  AddOutline(outline, intrinsics, frame, object.centroid.z(), seen);
  return seen;
}

}  // namespace fovea
