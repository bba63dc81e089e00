// Where lines run inside of the solid that an object is taken for.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/grasping/solid_pieces.h"
#include "core/shape/level_frame.h"
#include "core/types/detections.h"

namespace fovea {

// Part of a line, in lengths of its direction from its origin.
struct Span {
  float low = 0, high = 0;

  bool IsEmpty() const { return !(low < high); }
};

// Directions are unit vectors.
class Lines {
 public:
  void Clear() {
    for (std::vector<float>& axis : origins_) axis.clear();
    for (std::vector<float>& axis : directions_) axis.clear();
  }
  void Add(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) {
    for (int axis = 0; axis < 3; ++axis) {
      origins_[axis].push_back(origin[axis]);
      directions_[axis].push_back(direction[axis]);
    }
  }
  std::size_t Size() const { return origins_[0].size(); }
  const float* Origins(int axis) const { return origins_[axis].data(); }
  const float* Directions(int axis) const { return directions_[axis].data(); }

 private:
  std::array<std::vector<float>, 3> origins_, directions_;
};

// The completed solid of an object, in a level frame: all that is in some piece, and what is
// between two of them on a line. Where it is not known, its box.
class CompletedSolid {
 public:
  CompletedSolid(const DetectedObject& object, const LevelFrame& frame);

  bool IsKnown() const { return is_known_; }
  // Sets `spans` to that of each line, empty where it misses. Hollow solids count as filled. Cost:
  // lines times pieces, 32 lines at once.
  void Along(const Lines& lines, std::vector<Span>& spans) const;

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
