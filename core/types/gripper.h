// The hands that grasps are planned for. Metres; angles in radians.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>

namespace fovea {

// Two parallel fingers on a palm. In the hand's frame z is the approach, x the closing direction
// and y across both; the origin, the tool centre point, lies midway between the finger tips.
struct JawGripper {
  float max_opening_m = 0.085F;      // between the fingers
  float finger_length_m = 0.04F;     // from the palm to the tips, along z
  float finger_width_m = 0.02F;      // along y
  float finger_thickness_m = 0.01F;  // along x
  // Its box behind the fingers; 0 = as PalmOf says.
  Eigen::Vector3f palm_m{0, 0, 0};
  float friction = 0.5F;  // coefficient between finger and object
};

// The size of the box behind the fingers: where none is given as wide along x as the fingers at
// their widest with their thickness, 0.04 along y and z.
inline Eigen::Vector3f PalmOf(const JawGripper& gripper) {
  constexpr float kUsual_m = 0.04F;
  Eigen::Vector3f palm = gripper.palm_m;
  if (palm.x() <= 0) palm.x() = gripper.max_opening_m + 2 * gripper.finger_thickness_m;
  for (const int i : {1, 2}) {
    if (palm[i] <= 0) palm[i] = kUsual_m;
  }
  return palm;
}

// One cup at the end of a straight tube. The tool centre point is the middle of its lip.
struct SuctionGripper {
  float diameter_m = 0.03F;         // of the lip
  float max_curvature_per_m = 12;   // of a surface that the lip still seals on; 0 = flat only
  float max_unevenness_m = 0.002F;  // root mean square, from that surface
};

struct Gripper {
  std::string name;  // returned with its grasps
  std::variant<JawGripper, SuctionGripper> hand;
  // Preferred way to move in, unit vector in the camera frame; absent: along gravity.
  std::optional<Eigen::Vector3f> approach;
  float max_tilt_rad = 0.35F;  // of a grasp's approach from the preferred one; suction: 0.8
  int max_grasps = 5;          // returned for each object
  // What is less likely to succeed is not returned, 0 … 1.
  float min_probability = 0.5F;
};

}  // namespace fovea
