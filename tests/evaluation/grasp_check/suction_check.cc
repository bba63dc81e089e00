#include "tests/evaluation/grasp_check/suction_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/evaluation/grasp_check/body_surface.h"
#include "tests/evaluation/grasp_check/hand_boxes.h"

namespace fovea::evaluation {
namespace {

constexpr double kSweep_m = 0.15;
constexpr double kReach_m = 0.01;
constexpr double kTolerance_m = 0.001;
constexpr double kUnevenness_m = 0.0015;
constexpr double kOffMass_diameters = 4.0 / 3;
const double kMinFacing = std::cos(15 * std::numbers::pi / 180);

struct Place {
  double x, y, radius_m;  // across the lip
  double height_m = 0;    // of what it meets above the tool centre point, against the approach
};

// The middle first, then the inner ring, then the lip.
std::vector<Place> Places(double lip_radius_m) {
  constexpr int kDirections = 16;
  std::vector<Place> places = {{0, 0, 0}};
  for (const double radius_m : {lip_radius_m / 2, lip_radius_m}) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      places.push_back({radius_m * std::cos(angle), radius_m * std::sin(angle), radius_m});
    }
  }
  return places;
}

// The plane height = a x + b y + c of the lip, by least squares.
Eigen::Vector3d PlaneOfLip(const std::vector<Place>& places, double lip_radius_m) {
  Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Place& place : places) {
    if (place.radius_m < lip_radius_m) continue;
    const Eigen::Vector3d row(place.x, place.y, 1);
    sums += row * row.transpose();
    right += row * place.height_m;
  }
  return sums.ldlt().solve(right);
}

bool Seals(const std::vector<Place>& places, double lip_radius_m, double max_curvature_per_m) {
  const Eigen::Vector3d plane = PlaneOfLip(places, lip_radius_m);
  return std::all_of(places.begin(), places.end(), [&](const Place& place) {
    const double off = place.height_m - plane.dot(Eigen::Vector3d(place.x, place.y, 1));
    const double rise = lip_radius_m * lip_radius_m - place.radius_m * place.radius_m;
    return std::abs(off) <= kUnevenness_m + max_curvature_per_m * rise / 2;
  });
}

// The cup, from what it rests on backwards: two squares that fill it.
std::array<SolidBox, 2> SweptCup(const Eigen::Matrix3d& axes, const SuctionPose& pose,
                                 double lip_radius_m, double rests_at_m) {
  const double half = lip_radius_m / std::numbers::sqrt2 - kTolerance_m;
  const double end = -rests_at_m - 2 * kTolerance_m;
  const Eigen::Matrix3d turned =
      axes * Eigen::AngleAxisd(std::numbers::pi / 4, Eigen::Vector3d::UnitZ()).matrix();
  const auto box = [&](const Eigen::Matrix3d& hand) {
    return BoxOfHand(hand, pose.tool_center_point, {-half, -half, -kSweep_m}, {half, half, end});
  };
  return {box(axes), box(turned)};
}

double DistanceOfMass(const PhysicalScene& scene, int target, const SuctionPose& pose) {
  const scenes::Body& body = scene.Scene().bodies[static_cast<std::size_t>(target)];
  const Eigen::Vector3d mass = body.world_from_body * CenterOfMass(body.shape);
  return (mass - pose.tool_center_point).cross(pose.approach).norm();
}

}  // namespace

Outcome CheckSuction(const PhysicalScene& scene, int target, const SuctionGripper& gripper,
                     const SuctionPose& pose) {
  const double lip_radius_m = gripper.diameter_m / 2;
  const Eigen::Matrix3d axes = HandAxes(pose.approach, pose.approach.unitOrthogonal());
  std::vector<Place> places = Places(lip_radius_m);
  double rests_at_m = -kSweep_m, faces = 0;
  bool meets_all = true;
  for (Place& place : places) {
    const Eigen::Vector3d across(place.x, place.y, -kSweep_m);
    const scenes::Ray ray = {pose.tool_center_point + axes * across, axes.col(2)};
    const auto hit = scene.Nearest(ray);
    if (!hit || hit->hit.t > kSweep_m + 3 * kReach_m) {
      meets_all = false;
      continue;
    }
    place.height_m = kSweep_m - hit->hit.t;
    if (hit->body != target) {
      if (place.height_m > kReach_m) return Outcome::kOtherBodyFirst;
      meets_all = false;
      continue;
    }
    rests_at_m = std::max(rests_at_m, place.height_m);
    if (place.radius_m == 0) faces = -hit->hit.normal.dot(axes.col(2));
  }
  if (std::abs(rests_at_m) > kReach_m) {
    return rests_at_m > 0 ? Outcome::kHitsTarget : Outcome::kNoContact;
  }
  if (!meets_all) return Outcome::kNoSeal;
  const Outcome way_in = OnTheWayIn(scene, target, SweptCup(axes, pose, lip_radius_m, rests_at_m));
  if (way_in != Outcome::kSuccess) return way_in;
  if (faces < kMinFacing) return Outcome::kTilted;
  if (!Seals(places, lip_radius_m, gripper.max_curvature_per_m)) return Outcome::kNoSeal;
  const bool holds = DistanceOfMass(scene, target, pose) <= kOffMass_diameters * gripper.diameter_m;
  return holds ? Outcome::kSuccess : Outcome::kTooFarFromTheMass;
}

}  // namespace fovea::evaluation
