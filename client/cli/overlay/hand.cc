#include "client/cli/overlay/hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/cli/geometry.h"

namespace fovea::cli {
namespace {

// Where a server does not say what its hand is like.
constexpr double kFingerLength_m = 0.04, kFingerWidth_m = 0.02, kFingerThickness_m = 0.01,
                 kPalm_m = 0.04, kCup_m = 0.03, kTube_m = 0.06;

double Or(double value, double otherwise) { return value > 0 ? value : otherwise; }

struct Axes {
  cv::Vec3d x, y, z;  // closing, across, approach
};

Hand JawHand(const v1::Grasp& grasp, const v1::JawGripper& jaw, const Axes& axes) {
  const cv::Vec3d tip = ToVec(grasp.tool_center_point());
  const double length = Or(jaw.finger_length_m(), kFingerLength_m);
  const double width = Or(jaw.finger_width_m(), kFingerWidth_m);
  const double thickness = Or(jaw.finger_thickness_m(), kFingerThickness_m);
  const double widest = std::max(jaw.max_opening_m(), grasp.opening_m()) + 2 * thickness;
  const double palm_x = Or(jaw.palm_size().x(), widest);
  const double palm_y = Or(jaw.palm_size().y(), kPalm_m), palm_z = Or(jaw.palm_size().z(), kPalm_m);
  Hand hand;
  for (const double side : {-1.0, 1.0}) {
    hand.blocks.push_back(
        {tip + side * (grasp.opening_m() + thickness) / 2 * axes.x - length / 2 * axes.z,
         {thickness / 2 * axes.x, width / 2 * axes.y, length / 2 * axes.z}});
  }
  hand.blocks.push_back({tip - (length + palm_z / 2) * axes.z,
                         {palm_x / 2 * axes.x, palm_y / 2 * axes.y, palm_z / 2 * axes.z}});
  hand.back = tip - (length + palm_z) * axes.z;
  return hand;
}

// A circle across the axis z.
void AddCircle(const cv::Vec3d& center, double radius, const Axes& axes,
               std::vector<SpaceLine>* lines) {
  constexpr int kSteps = 32;
  const auto at = [&](int step) {
    const double angle = 2 * std::numbers::pi * step / kSteps;
    return center + radius * (std::cos(angle) * axes.x + std::sin(angle) * axes.y);
  };
  for (int step = 0; step < kSteps; ++step) lines->push_back({at(step), at(step + 1)});
}

// The lip, half as wide a way behind it, and the tube.
Hand SuctionHand(const v1::Grasp& grasp, const v1::SuctionGripper& cup, const Axes& axes) {
  const cv::Vec3d lip = ToVec(grasp.tool_center_point());
  const double radius = Or(cup.diameter_m(), kCup_m) / 2;
  const cv::Vec3d neck = lip - radius * axes.z;
  Hand hand;
  AddCircle(lip, radius, axes, &hand.lines);
  AddCircle(neck, radius / 2, axes, &hand.lines);
  for (const cv::Vec3d& side : {axes.x, -axes.x, axes.y, -axes.y}) {
    hand.lines.push_back({lip + radius * side, neck + radius / 2 * side});
  }
  hand.back = lip - kTube_m * axes.z;
  hand.lines.push_back({neck, hand.back});
  return hand;
}

}  // namespace

Hand HandOf(const v1::Grasp& grasp,
            const google::protobuf::RepeatedPtrField<v1::Gripper>& grippers) {
  const cv::Vec3d z = cv::normalize(ToVec(grasp.approach()));
  const cv::Vec3d x = cv::normalize(ToVec(grasp.closing()));
  const Axes axes{x, z.cross(x), z};
  const auto index = static_cast<int>(grasp.gripper_index());
  const v1::Gripper gripper =
      index >= 0 && index < grippers.size() ? grippers.Get(index) : v1::Gripper();
  return grasp.kind() == v1::GRASP_KIND_SUCTION ? SuctionHand(grasp, gripper.suction(), axes)
                                                : JawHand(grasp, gripper.jaw(), axes);
}

}  // namespace fovea::cli
