#include "tests/support/labelled_frame.h"

#include <opencv2/core.hpp>

#include "tests/support/render.h"

namespace fovea::scenes {
namespace {

std::vector<ObjectTruth> TrueObjects(const Scene& scene, const cv::Mat& labels) {
  const Eigen::Isometry3d camera_from_world = scene.camera.world_from_camera.inverse();
  std::vector<ObjectTruth> objects;
  for (const Body& body : scene.bodies) {
    if (!body.is_object) continue;
    const int label = static_cast<int>(objects.size()) + 1;
    objects.push_back({label, body.name, body.shape, camera_from_world * body.world_from_body,
                       cv::countNonZero(labels == label)});
  }
  return objects;
}

SupportSurface InCamera(const Support& support, const Camera& camera) {
  const Eigen::Vector3d up = camera.world_from_camera.linear().row(2);
  const double camera_height_m = camera.world_from_camera.translation().z();
  SupportSurface surface;
  surface.normal = up.cast<float>();
  surface.offset_m = static_cast<float>(camera_height_m - support.height_m);
  return surface;
}

}  // namespace

LabelledFrame MakeFrame(const Scene& scene, SensorKind sensor, std::uint64_t seed) {
  const Rendering rendering = Render(scene, BaselineOf(sensor));
  const CameraIntrinsics& intrinsics = scene.camera.intrinsics;
  LabelledFrame labelled;
  labelled.frame.color_rgb = MeasureColor(rendering, sensor, seed);
  labelled.frame.depth_m = MeasureDepth(rendering, sensor, intrinsics.fx_px, seed);
  labelled.frame.intrinsics = intrinsics;
  labelled.labels = rendering.labels;
  labelled.objects = TrueObjects(scene, rendering.labels);
  labelled.gravity = -scene.camera.world_from_camera.linear().row(2).cast<float>();
  for (const Support& support : scene.supports) {
    labelled.supports.push_back(InCamera(support, scene.camera));
  }
  return labelled;
}

}  // namespace fovea::scenes
