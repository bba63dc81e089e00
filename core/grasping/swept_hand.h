// The room that an open hand takes on its way in.
#pragma once

#include <Eigen/Core>
#include <array>

#include "core/types/grasp.h"
#include "core/types/gripper.h"

namespace fovea {

// Both fingers and the palm, each a box from where it ends in the grasp back to where it was in the
// pre-grasp. In the frame of the hand (gripper.h).
class SweptHand {
 public:
  // A box, on one side of the hand as on the other: of |x| and |y|.
  struct Part {
    float low_x = 0, high_x = 0, high_y = 0, low_z = 0, high_z = 0;
  };

  static constexpr int kTogether = 64;
  using Each = std::array<float, kTogether>;

  SweptHand(const JawGripper& jaw, const Grasp& grasp);

  Eigen::Vector3f FromCamera(const Eigen::Vector3f& p) const {
    return rotation_.transpose() * (p - origin_);
  }
  Eigen::Vector3f ToCamera(const Eigen::Vector3f& p) const { return origin_ + rotation_ * p; }

  // Squared, of a point in the frame of the hand; 0 within it.
  float SquaredDistance(float x, float y, float z) const;
  // The same of points in the camera's frame, many at once; huge where they are not numbers.
  Each SquaredDistances(const Each& x, const Each& y, const Each& z) const;

  Eigen::Vector3f Axis(int i) const { return rotation_.col(i); }
  // How far back from the tool centre point the fingers reach, with the way in.
  float Back() const { return -fingers_.low_z; }
  // The box around all of it.
  Eigen::Vector3f Low() const { return {-reach_.x(), -reach_.y(), palm_.low_z}; }
  Eigen::Vector3f High() const { return {reach_.x(), reach_.y(), fingers_.high_z}; }
  // The ends of its boxes that go ahead: four corners of each.
  std::array<Eigen::Vector3f, 12> Corners() const;

 private:
  Eigen::Matrix3f rotation_;
  Eigen::Vector3f origin_;
  Part fingers_, palm_;
  Eigen::Vector2f reach_;
};

}  // namespace fovea
