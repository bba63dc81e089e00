// What the solid that an object is taken for is made of.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/types/detections.h"

namespace fovea {

// A box, sphere or cylinder, in the axes of an object's box, from the middle of the solid.
struct SolidPiece {
  enum class Kind { kBox, kSphere, kCylinder };
  Kind kind = Kind::kBox;
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  Eigen::Vector3f half = Eigen::Vector3f::Zero();   // of boxes
  Eigen::Vector3f axis = Eigen::Vector3f::UnitZ();  // of cylinders: unit vector
  float radius_m = 0, half_length_m = 0;
};

// Together they are the solid; of what has no named shape and form, its box.
std::vector<SolidPiece> PiecesOf(const DetectedObject& object);

}  // namespace fovea
