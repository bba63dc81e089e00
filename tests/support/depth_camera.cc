#include "tests/support/depth_camera.h"

#include <cmath>
#include <numbers>

#include "tests/support/render.h"

namespace fovea::scenes {

DepthCamera DepthCameraBeside(double baseline_m, const cv::Size& size_px) {
  constexpr double kDegree = std::numbers::pi / 180;
  const double focal_px = size_px.width / 2.0 / std::tan(33 * kDegree);
  DepthCamera camera;
  camera.intrinsics = {focal_px, focal_px, (size_px.width - 1) / 2.0, (size_px.height - 1) / 2.0};
  camera.size_px = size_px;
  camera.color_from_depth = Eigen::Translation3d(-baseline_m, 0, 0) *
                            Eigen::AngleAxisd(kDegree, Eigen::Vector3d::UnitY());
  return camera;
}

Scene SeenBy(const DepthCamera& camera, const Scene& scene) {
  Scene seen = scene;
  seen.camera = {camera.intrinsics, camera.size_px,
                 scene.camera.world_from_camera * camera.color_from_depth};
  return seen;
}

cv::Mat MeasureDepth(const Scene& scene, const DepthCamera& camera, SensorKind sensor,
                     std::uint64_t seed) {
  const Rendering rendering = Render(SeenBy(camera, scene), BaselineOf(sensor));
  return MeasureDepth(rendering, sensor, camera.intrinsics.fx_px, seed);
}

}  // namespace fovea::scenes
