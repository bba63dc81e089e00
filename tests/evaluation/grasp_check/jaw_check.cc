#include "tests/evaluation/grasp_check/jaw_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/evaluation/grasp_check/hand_boxes.h"

namespace fovea::evaluation {
namespace {

constexpr double kSweep_m = 0.15;
constexpr double kTolerance_m = 0.001;
constexpr double kMargin_m = 0.01;  // on each side of what the object needs
constexpr double kGrid_m = 0.002;
constexpr double kBehindPad_m = 0.002;  // where rays start, so that touching things are met too
constexpr double kPatch_m = 0.001;

struct PadRay {
  scenes::Ray ray;
  Eigen::Array2d at;  // across the pad: y and z of the hand
};

// Rays from one pad in the direction it closes; `side` is -1 for the finger that closes towards
// +closing.
std::vector<PadRay> RaysOfPad(const JawGripper& gripper, const JawPose& pose, double opening_m,
                              int side) {
  const Eigen::Matrix3d axes = HandAxes(pose.approach, pose.closing);
  const double x = side * (opening_m / 2 + kBehindPad_m);
  const double half_width = gripper.finger_width_m / 2;
  std::vector<PadRay> rays;
  for (double z = kGrid_m / 2; z < gripper.finger_length_m; z += kGrid_m) {
    for (double y = -half_width + kGrid_m / 2; y < half_width; y += kGrid_m) {
      rays.push_back(
          {{pose.tool_center_point + axes * Eigen::Vector3d(x, y, -z), -side * axes.col(0)},
           {y, -z}});
    }
  }
  return rays;
}

// One finger's contact: travel, normal and patch number `index`.
bool Close(const PhysicalScene& scene, int target, const std::vector<PadRay>& rays,
           double opening_m, int index, JawContacts& contacts) {
  std::vector<std::pair<const PadRay*, scenes::Hit>> hits;
  double first = std::numeric_limits<double>::infinity();
  for (const PadRay& pad : rays) {
    const double max_t = std::min(opening_m + kBehindPad_m, first + kPatch_m);
    const auto hit = scene.Meets(target, pad.ray, max_t);
    if (!hit) continue;
    first = std::min(first, hit->t);
    hits.emplace_back(&pad, *hit);
  }
  if (hits.empty()) return false;
  contacts.travel_m[index] = first - kBehindPad_m;
  contacts.low[index].setConstant(std::numeric_limits<double>::infinity());
  contacts.high[index] = -contacts.low[index];
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();
  for (const auto& [pad, hit] : hits) {
    if (hit.t > first + kPatch_m) continue;
    normals += hit.normal;
    contacts.low[index] = contacts.low[index].min(pad->at);
    contacts.high[index] = contacts.high[index].max(pad->at);
  }
  contacts.normal[index] = normals.normalized();
  return true;
}

bool Holds(const JawContacts& contacts, const JawPose& pose, double opening_m, double friction) {
  const double width_m = opening_m - contacts.travel_m[0] - contacts.travel_m[1];
  if (width_m <= 0) return false;
  // From patch 0 to the nearest point of patch 1.
  const Eigen::Array2d up = (contacts.low[1] - contacts.high[0]).max(0);
  const Eigen::Array2d down = (contacts.low[0] - contacts.high[1]).max(0);
  const Eigen::Array2d gap = up - down;
  const Eigen::Matrix3d axes = HandAxes(pose.approach, pose.closing);
  const Eigen::Vector3d line = axes * Eigen::Vector3d(width_m, gap.x(), gap.y()).normalized();
  const double cosine = std::cos(std::atan(friction));
  const auto within = [&](const Eigen::Vector3d& direction) {
    return -direction.dot(contacts.normal[0]) >= cosine &&
           direction.dot(contacts.normal[1]) >= cosine;
  };
  return within(axes.col(0)) && within(line);
}

// Whether a pad meets something else within its travel.
bool MeetsOther(const PhysicalScene& scene, int target, const std::vector<PadRay>& rays,
                double travel_m) {
  return std::any_of(rays.begin(), rays.end(), [&](const PadRay& pad) {
    const auto hit = scene.Nearest(pad.ray);
    return hit && hit->body != target && hit->hit.t < kBehindPad_m + travel_m - kTolerance_m;
  });
}

}  // namespace

std::optional<JawContacts> CloseOn(const PhysicalScene& scene, int target,
                                   const JawGripper& gripper, const JawPose& pose,
                                   double opening_m) {
  JawContacts contacts;
  for (const int index : {0, 1}) {
    const auto rays = RaysOfPad(gripper, pose, opening_m, index == 0 ? -1 : 1);
    if (!Close(scene, target, rays, opening_m, index, contacts)) return std::nullopt;
  }
  return contacts;
}

Outcome CheckJaw(const PhysicalScene& scene, int target, const JawGripper& gripper,
                 const JawPose& pose) {
  if (pose.opening_m > gripper.max_opening_m) return Outcome::kTooWide;
  const double moving_in_m =
      pose.moving_in_m > 0 ? pose.moving_in_m : pose.opening_m + 2 * kMargin_m;
  const double opening_m = std::min<double>(gripper.max_opening_m, moving_in_m);
  const Outcome way_in =
      OnTheWayIn(scene, target, SweptHand(gripper, pose, opening_m, kSweep_m, kTolerance_m));
  if (way_in != Outcome::kSuccess) return way_in;
  const auto contacts = CloseOn(scene, target, gripper, pose, opening_m);
  if (!contacts) return Outcome::kNoContact;
  for (const int index : {0, 1}) {
    const auto rays = RaysOfPad(gripper, pose, opening_m, index == 0 ? -1 : 1);
    if (MeetsOther(scene, target, rays, contacts->travel_m[index])) {
      return Outcome::kOtherBodyFirst;
    }
  }
  return Holds(*contacts, pose, opening_m, gripper.friction) ? Outcome::kSuccess : Outcome::kSlips;
}

}  // namespace fovea::evaluation
