// A frame with everything that is true about it.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"
#include "tests/support/scene.h"
#include "tests/support/sensor.h"

namespace fovea::scenes {

struct ObjectTruth {
  int label = 0;     // its value in LabelledFrame::labels
  std::string name;  // of its kind, for example "bowl"
  Shape shape;
  Eigen::Isometry3d camera_from_object;
  int num_pixels = 0;  // visible, with or without measured depth
};

struct LabelledFrame {
  RgbdFrame frame;  // gravity is not set: copy it from below where the detector shall be told
  cv::Mat labels;   // CV_16UC1, 0 = not an object, k = object k; also where depth is missing
  std::vector<ObjectTruth> objects;      // object k at k - 1
  Eigen::Vector3f gravity;               // unit vector, camera frame, points down
  std::vector<SupportSurface> supports;  // camera frame; on which objects may stand
};

// What the sensor sees of the scene. Same scene, sensor and seed, same bytes.
LabelledFrame MakeFrame(const Scene& scene, SensorKind sensor, std::uint64_t seed);

}  // namespace fovea::scenes
