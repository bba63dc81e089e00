#include "core/grasping/swept_hand.h"

#include <algorithm>
#include <cmath>

#include "core/types/widest_registers.h"

namespace fovea {
namespace {

FOVEA_INLINE float SquaredTo(const SweptHand::Part& part, float x, float y, float z) {
  const float dx = std::max(std::max(part.low_x - x, x - part.high_x), 0.0F);
  const float dy = std::max(y - part.high_y, 0.0F);
  const float dz = std::max(std::max(part.low_z - z, z - part.high_z), 0.0F);
  return dx * dx + (dy * dy + dz * dz);
}

}  // namespace

SweptHand::SweptHand(const JawGripper& jaw, const Grasp& grasp) : origin_(grasp.tool_center_point) {
  rotation_ << grasp.closing, grasp.approach.cross(grasp.closing), grasp.approach;
  const Eigen::Vector3f palm = PalmOf(jaw);
  const float inside = grasp.pre_grasp_opening_m / 2, back = grasp.pre_grasp_distance_m;
  fingers_ = {inside, inside + jaw.finger_thickness_m, jaw.finger_width_m / 2,
              -jaw.finger_length_m - back, 0};
  palm_ = {0, palm.x() / 2, palm.y() / 2, -jaw.finger_length_m - palm.z() - back,
           -jaw.finger_length_m};
  reach_ = {std::max(fingers_.high_x, palm_.high_x), std::max(fingers_.high_y, palm_.high_y)};
}

float SweptHand::SquaredDistance(float x, float y, float z) const {
  x = std::abs(x), y = std::abs(y);
  return std::min(SquaredTo(fingers_, x, y, z), SquaredTo(palm_, x, y, z));
}

SweptHand::Each SweptHand::SquaredDistances(const Each& x, const Each& y, const Each& z) const {
  Each squared;
  RunInWidestRegisters([&] {
    constexpr float kHuge = 1e6F;
    const Eigen::Matrix3f axes = rotation_.transpose();
    const Eigen::Vector3f origin = axes * origin_;
    const Part fingers = fingers_, palm = palm_;
    Each own;  // of its own, as all that the loop reads is
    for (int i = 0; i < kTogether; ++i) {
      const float u = axes(0, 0) * x[i] + (axes(0, 1) * y[i] + axes(0, 2) * z[i]) - origin[0];
      const float v = axes(1, 0) * x[i] + (axes(1, 1) * y[i] + axes(1, 2) * z[i]) - origin[1];
      const float w = axes(2, 0) * x[i] + (axes(2, 1) * y[i] + axes(2, 2) * z[i]) - origin[2];
      const float to_fingers = SquaredTo(fingers, std::abs(u), std::abs(v), w);
      const float to_palm = SquaredTo(palm, std::abs(u), std::abs(v), w);
      own[i] = z[i] == z[i] ? std::min(to_fingers, to_palm) : kHuge;
    }
    squared = own;
  });
  return squared;
}

std::array<Eigen::Vector3f, 12> SweptHand::Corners() const {
  std::array<Eigen::Vector3f, 12> corners;
  auto* next = corners.data();
  for (const float y : {-1.0F, 1.0F}) {
    for (const float x : {-fingers_.high_x, -fingers_.low_x, fingers_.low_x, fingers_.high_x}) {
      *next++ = {x, y * fingers_.high_y, fingers_.high_z};
    }
    for (const float x : {-palm_.high_x, palm_.high_x}) {
      *next++ = {x, y * palm_.high_y, palm_.high_z};
    }
  }
  return corners;
}

}  // namespace fovea
