// What motion planners need of a scene. Camera frame, metres.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

namespace fovea {

// A solid that collision checkers know.
struct CollisionPrimitive {
  enum class Kind { kBox, kCylinder, kSphere };
  Kind kind = Kind::kBox;
  // Of its middle; the axis of a cylinder is z.
  Eigen::Isometry3f pose = Eigen::Isometry3f::Identity();
  // Full extents along its axes: of cylinders x = y = the diameter, of spheres all three.
  Eigen::Vector3f size_m = Eigen::Vector3f::Zero();
};

// How high what was seen reaches, on a level grid; things without depth by their assumed front.
struct HeightMap {
  // Columns of the rotation: x along a row of cells, y from row to row, z up. The origin is the
  // middle of the first cell at height 0.
  Eigen::Isometry3f pose = Eigen::Isometry3f::Identity();
  float cell_m = 0;
  cv::Mat heights_m;  // CV_32FC1; of the highest point in each cell, NaN = unknown
};

struct PlanningOptions {
  bool collision_primitives = false;
  bool height_map = false;
  float cell_m = 0.02F;       // of the height map
  int max_cells = 256 * 256;  // of the height map
};

}  // namespace fovea
