// Where a line runs inside of the solid that an object is taken for.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/shape/level_frame.h"
#include "core/types/detections.h"

namespace fovea {

// Part of a line, in lengths of its direction from its origin.
struct Span {
  float low = 0, high = 0;
};

// A box, sphere or cylinder, in the axes of an object's box, from the middle of the solid.
struct SolidPiece {
  enum class Kind { kBox, kSphere, kCylinder };
  Kind kind = Kind::kBox;
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  Eigen::Vector3f half = Eigen::Vector3f::Zero();   // of boxes
  Eigen::Vector3f axis = Eigen::Vector3f::UnitZ();  // of cylinders: unit vector
  float radius_m = 0, half_length_m = 0;
};

// The completed solid of an object, in a level frame: all that is in some piece, and what is
// between two of them on a line. Where it is not known, its box.
class CompletedSolid {
 public:
  CompletedSolid(const DetectedObject& object, const LevelFrame& frame);

  bool IsKnown() const { return is_known_; }
  // Hollow ones count as filled. `direction`: unit vector. Takes some 10 ns for each piece.
  std::optional<Span> Along(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const;

  // Half of the solid's extents along the axes of the frame, and its middle.
  const Eigen::Vector3f& HalfExtents() const { return half_extents_; }
  const Eigen::Vector3f& Center() const { return center_; }

 private:
  bool is_known_ = true;
  Eigen::Vector3f center_;          // in the frame
  Eigen::Matrix3f frame_from_box_;  // the axes of the box as columns
  Eigen::Vector3f half_extents_;    // of the box, along the frame's axes
  std::vector<SolidPiece> pieces_;
};

}  // namespace fovea
