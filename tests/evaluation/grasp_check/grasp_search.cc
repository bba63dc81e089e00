#include "tests/evaluation/grasp_check/grasp_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "tests/evaluation/grasp_check/body_surface.h"
#include "tests/evaluation/grasp_check/jaw_check.h"
#include "tests/evaluation/grasp_check/suction_check.h"

namespace fovea::evaluation {
namespace {

constexpr double kStep_m = 0.01;
constexpr int kMaxSteps = 12;

// Evenly spaced from low to high, at most so many; those in the middle first.
std::vector<double> FromTheMiddle(double low, double high) {
  const int steps = std::clamp(static_cast<int>(std::ceil((high - low) / kStep_m)), 2, kMaxSteps);
  std::vector<double> values;
  for (int i = 0; i <= steps; ++i) values.push_back(low + (high - low) * i / steps);
  const double middle = (low + high) / 2;
  std::stable_sort(values.begin(), values.end(),
                   [&](double a, double b) { return std::abs(a - middle) < std::abs(b - middle); });
  return values;
}

struct Bounds {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
};

// Around the body along these axes (columns).
Bounds BoundsOf(const scenes::Body& body, const Eigen::Matrix3d& axes) {
  Bounds bounds;
  for (const Eigen::Vector3d& point : HullPoints(body.shape)) {
    const Eigen::Vector3d along = axes.transpose() * (body.world_from_body * point);
    bounds.low = bounds.low.cwiseMin(along);
    bounds.high = bounds.high.cwiseMax(along);
  }
  return bounds;
}

// Heights of the finger tips.
std::set<double> TipHeights(double low, double high) {
  const double lowest = low + 0.0015, highest = std::max(lowest, high - 0.003);
  std::set<double> heights;
  for (const double height :
       {lowest, (low + high) / 2, high - 0.005, high - 0.01, high - 0.02, high - 0.035}) {
    heights.insert(std::clamp(height, lowest, highest));
  }
  return heights;
}

// Closing from `from_m` around the pose tells what the object needs there, and where its middle is.
bool Takes(const PhysicalScene& scene, int target, const JawGripper& jaw, JawPose pose,
           double from_m) {
  const auto contacts = CloseOn(scene, target, jaw, pose, from_m);
  if (!contacts) return false;
  const double width_m = from_m - contacts->travel_m[0] - contacts->travel_m[1];
  if (width_m <= 0) return false;
  pose.tool_center_point += pose.closing * (contacts->travel_m[0] - contacts->travel_m[1]) / 2;
  pose.opening_m = width_m;
  return CheckJaw(scene, target, jaw, pose) == Outcome::kSuccess;
}

bool JawTakes(const PhysicalScene& scene, int target, const JawGripper& jaw) {
  constexpr int kYaws = 12;
  constexpr double kNarrow_m = 0.03;  // to close on a rim from within
  const scenes::Body& body = scene.Scene().bodies[static_cast<std::size_t>(target)];
  for (int i = 0; i < kYaws; ++i) {
    const double yaw = std::numbers::pi * i / kYaws;
    const Eigen::Matrix3d axes =
        Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Bounds bounds = BoundsOf(body, axes);
    for (const double x : FromTheMiddle(bounds.low.x(), bounds.high.x())) {
      for (const double y : FromTheMiddle(bounds.low.y(), bounds.high.y())) {
        for (const double z : TipHeights(bounds.low.z(), bounds.high.z())) {
          const JawPose pose = {axes * Eigen::Vector3d(x, y, z), -Eigen::Vector3d::UnitZ(),
                                axes.col(0), 0};
          if (Takes(scene, target, jaw, pose, jaw.max_opening_m) ||
              Takes(scene, target, jaw, pose, kNarrow_m)) {
            return true;
          }
        }
      }
    }
  }
  return false;
}

bool SuctionTakes(const PhysicalScene& scene, int target, const SuctionGripper& suction,
                  double max_tilt_rad) {
  const scenes::Body& body = scene.Scene().bodies[static_cast<std::size_t>(target)];
  const Bounds bounds = BoundsOf(body, Eigen::Matrix3d::Identity());
  for (const double x : FromTheMiddle(bounds.low.x(), bounds.high.x())) {
    for (const double y : FromTheMiddle(bounds.low.y(), bounds.high.y())) {
      const scenes::Ray down = {{x, y, bounds.high.z() + 0.01}, -Eigen::Vector3d::UnitZ()};
      const auto hit = scene.Meets(target, down, 10);
      if (!hit || hit->normal.z() < std::cos(max_tilt_rad)) continue;
      if (CheckSuction(scene, target, suction, {down.At(hit->t), -hit->normal}) ==
          Outcome::kSuccess) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

bool IsPossible(const PhysicalScene& scene, int target, const Gripper& gripper) {
  if (const auto* suction = std::get_if<SuctionGripper>(&gripper.hand)) {
    return SuctionTakes(scene, target, *suction, gripper.max_tilt_rad);
  }
  return JawTakes(scene, target, std::get<JawGripper>(gripper.hand));
}

}  // namespace fovea::evaluation
