#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/types/detections.h"
#include "core/types/gripper.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

// An object's attributes, without mask and cloud. `reference_from_camera` is the camera's pose,
// where the frame gave one; `grippers`: those that its grasps are for.
v1::Object ToProto(const DetectedObject& object, const std::string& frame_id,
                   const std::optional<Eigen::Isometry3d>& reference_from_camera,
                   const std::vector<Gripper>& grippers);

v1::OrientedBox ToProto(const OrientedBox& box);

v1::PointCloud CloudToProto(const std::vector<ColoredPoint>& cloud);

}  // namespace fovea::server
