// A depth camera beside the colour camera, as in sensors that do not register depth themselves.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "tests/support/scene.h"
#include "tests/support/sensor.h"

namespace fovea::scenes {

struct DepthCamera {
  CameraIntrinsics intrinsics;
  cv::Size size_px;
  Eigen::Isometry3d color_from_depth = Eigen::Isometry3d::Identity();
};

// One of this size with a field of view 66° across (that of colour is 63°), `baseline_m` to the
// left of the colour camera and turned by 1° towards it.
DepthCamera DepthCameraBeside(double baseline_m, const cv::Size& size_px);

// The scene, seen by that camera instead of the scene's.
Scene SeenBy(const DepthCamera& camera, const Scene& scene);

// What the depth camera measures: CV_32FC1, metres along its own z, NaN = none.
cv::Mat MeasureDepth(const Scene& scene, const DepthCamera& camera, SensorKind sensor,
                     std::uint64_t seed);

}  // namespace fovea::scenes
