// Where a line runs inside of the solid that an object is taken for.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/shape/shape_fit.h"
#include "core/types/detections.h"

namespace fovea {

// Part of a line, in lengths of its direction from its origin.
struct Span {
  float low = 0, high = 0;
};

// The completed solid of an object, in a level frame. Of kOther it is not known: only its box is.
class CompletedSolid {
 public:
  CompletedSolid(const DetectedObject& object, const LevelFrame& frame);

  bool IsKnown() const { return kind_ != Shape::Kind::kOther; }
  // Hollow ones count as filled. `direction`: unit vector. Takes some 10 ns.
  std::optional<Span> Along(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const;

  // Half of the solid's extents along the axes of the frame, and its middle.
  const Eigen::Vector3f& HalfExtents() const { return half_extents_; }
  const Eigen::Vector3f& Center() const { return center_; }

 private:
  Shape::Kind kind_ = Shape::Kind::kOther;
  Eigen::Vector3f center_;                   // of the box, in the frame
  Eigen::Matrix3f frame_from_box_;           // its axes as columns; of what has an axis, that
                                             // is the third
  Eigen::Vector3f half_box_, half_extents_;  // of the box along its axes; along the frame's
  float radius_m_ = 0, half_length_m_ = 0;
  std::vector<float> radii_m_;
};

}  // namespace fovea
