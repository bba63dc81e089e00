#include "core/grasping/suction_grasps.h"

#include <algorithm>
#include <cmath>

#include "core/grasping/suction_patch.h"
#include "core/grasping/suction_places.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr int kSteps = 15;  // along the tube

// The smallest distance between the tube and what else is in the columns of the grid, up to 20 mm;
// negative where they meet.
float TubeGap(const HandGrid& grid, const Eigen::Vector3f& center, const Eigen::Vector3f& normal,
              float radius_m, float length_m) {
  constexpr float kFarthest_m = 0.02F, kOnPatch_m = 0.006F;
  const Eigen::Vector3f start = grid.frame.FromCamera(center);
  const Eigen::Vector3f way = grid.frame.rotation.transpose() * normal;
  const Eigen::Vector3f u = way.unitOrthogonal(), v = way.cross(u);
  float gap = kFarthest_m;
  for (int step = 0; step < kSteps; ++step) {
    const float along = kOnPatch_m + static_cast<float>(step) * length_m / kSteps;
    for (const float wider : {0.0F, 0.005F, 0.01F, 0.02F}) {
      for (const auto& [c, s] : kAroundLip) {
        const Eigen::Vector3f at = start + along * way + (radius_m + wider) * (c * u + s * v);
        const int x = grid.CellAt(at.x()), y = grid.CellAt(at.y());
        if (x < 0 || y < 0 || x >= grid.size || y >= grid.size) continue;
        if (grid.At(y, x).other <= at.z()) continue;
        gap = std::min(gap, wider > 0 ? wider - 0.005F : -kFarthest_m);
      }
    }
  }
  return gap;
}

// How far back a cup is clear of everything: out of what is hollow.
float PreGraspDistance(const DetectedObject& object, const CompletedSolid& solid,
                       const LevelFrame& frame, const Eigen::Vector3f& center) {
  if (!object.shape.hollow) return kLeastPreGrasp_m;
  const float top = solid.Center().z() + solid.HalfExtents().z();
  return std::max(kLeastPreGrasp_m, top - frame.FromCamera(center).z() + kPreGraspBeyond_m);
}

// A lip follows more than the largest curvature where that is still even to it.
constexpr float kMostCurvature = 2.2F;  // times the largest

bool IsEven(const SuctionPatch& patch, const SuctionGripper& cup, float noise_m) {
  constexpr float kLeastCovered = 0.6F;
  return patch.unevenness_m < cup.max_unevenness_m + 2 * noise_m && patch.covered >= kLeastCovered;
}

// Of a few sizes from that of the cup on, in its own: the widest that would lie on what is seen of
// the object, and the widest that would lie on the whole of it, too.
struct WidestCup {
  float on_seen = 1, on_whole = 1;
};

WidestCup WidestAt(const GraspScene& scene, const DetectedObject& object,
                   const CompletedSolid& solid, const LevelFrame& frame, const SuctionPlace& place,
                   const SuctionGripper& cup, float noise_m) {
  constexpr float kAllAround = 0.95F;
  const bool is_solid_known = solid.IsKnown() && (place.is_inside || !object.shape.hollow);
  WidestCup widest;
  bool is_on_whole = true;
  for (const float times : {1.25F, 1.5F, 2.0F, 3.0F}) {
    const float diameter = times * cup.diameter_m;
    const auto wider = PatchAt(scene, object.label, place.pixel, place.center, diameter);
    if (!wider || !IsEven(*wider, cup, noise_m)) break;
    widest.on_seen = times;
    is_on_whole =
        is_on_whole && (is_solid_known ? IsOnSolid(object, solid, frame, place, cup, diameter / 2)
                                       : wider->covered >= kAllAround);
    if (is_on_whole) widest.on_whole = times;
  }
  return widest;
}

bool Seals(const SuctionPlace& place, const SuctionGripper& cup, float noise_m) {
  const bool is_even = place.of_solid
                           ? place.seen.unevenness_m <= cup.max_unevenness_m + 2 * noise_m
                           : IsEven(place.seen, cup, noise_m);
  return is_even && place.curvature_per_m <= kMostCurvature * cup.max_curvature_per_m;
}

// A lip gives way: a gripper that may tilt less than this takes what is no more out of true.
constexpr float kLipGives_rad = 0.05F;

// Whether a cup reaches the place. The way that the grid is against and the preferred one are the
// same or both ends of how far the gripper may tilt.
bool IsWithinReach(const SuctionPlace& place, const Gripper& gripper,
                   const Eigen::Vector3f& approach, const Eigen::Vector3f& preferred) {
  const float cosine = -std::max(place.normal.dot(approach), place.normal.dot(preferred));
  return cosine >= std::cos(std::max(gripper.max_tilt_rad, kLipGives_rad));
}

// Out of the place: its normal or, where the gripper may not tilt that far, as near to it as it
// may.
Eigen::Vector3f AxisAt(const SuctionPlace& place, const Gripper& gripper,
                       const Eigen::Vector3f& preferred) {
  const float along = -place.normal.dot(preferred), most = std::cos(gripper.max_tilt_rad);
  if (along >= most) return place.normal;
  const Eigen::Vector3f aside = (place.normal + along * preferred).normalized();
  return std::sqrt(1 - most * most) * aside - most * preferred;
}

// What is in the way of the tube.
NoGrasp::Reason WhatBlocksTube(const HandGrid& grid, const Eigen::Vector3f& center) {
  constexpr float kOnPatch_m = 0.006F;
  const Eigen::Vector3f at = grid.frame.FromCamera(center);
  const int x = grid.CellAt(at.x()), y = grid.CellAt(at.y());
  if (x < 0 || y < 0 || x >= grid.size || y >= grid.size) return NoGrasp::Reason::kNeighbor;
  const float other = grid.At(y, x).other;
  if (HandGrid::IsFloorInTheWay(other)) return NoGrasp::Reason::kTooLow;
  return other > at.z() + kOnPatch_m ? NoGrasp::Reason::kCovered : NoGrasp::Reason::kNeighbor;
}

}  // namespace

std::vector<ScoredGrasp> FindSuctionGrasps(const GraspScene& scene, const DetectedObject& object,
                                           const GraspTerms& of_object, const HandGrid& grid,
                                           const Gripper& gripper, std::size_t index,
                                           Failures& failures) {
  constexpr float kNoise_m = 0.001F, kNoisePerM = 0.002F;  // of depth, per square metre
  const auto& cup = std::get<SuctionGripper>(gripper.hand);
  const Eigen::Vector3f approach = -grid.frame.rotation.col(2);
  const Eigen::Vector3f preferred = gripper.approach.value_or(-scene.up);
  const CompletedSolid solid(object, grid.frame);
  int num_missed = 0;
  std::vector<SuctionPlace> places = SeenPlaces(scene, object, cup.diameter_m, num_missed);
  for (int i = 0; i < num_missed; ++i) failures.Add(NoGrasp::Reason::kTooLittleSeen);
  const auto of_solid = SolidPlaces(scene, object, approach, cup.diameter_m);
  places.insert(places.end(), of_solid.begin(), of_solid.end());
  const bool any_within_reach = std::any_of(places.begin(), places.end(), [&](const auto& place) {
    return IsWithinReach(place, gripper, approach, preferred);
  });
  std::vector<ScoredGrasp> grasps;
  for (const SuctionPlace& place : places) {
    InterruptionPoint();
    const Eigen::Vector3f normal = AxisAt(place, gripper, preferred);
    const float noise = kNoise_m + kNoisePerM * place.center.z() * place.center.z();
    if (!IsWithinReach(place, gripper, approach, preferred)) {
      // The front of a box says nothing of its top.
      if (!place.of_solid && !any_within_reach) failures.Add(NoGrasp::Reason::kSloped);
      continue;
    }
    if (!Seals(place, cup, noise)) {
      if (!place.of_solid) failures.Add(NoGrasp::Reason::kNoSeal);
      continue;
    }
    const float back_m = PreGraspDistance(object, solid, grid.frame, place.center);
    const float gap =
        TubeGap(grid, place.center, normal, cup.diameter_m / 2, std::max(kLeastWay_m, back_m));
    if (gap < 0) {
      failures.Add(WhatBlocksTube(grid, place.center));
      continue;
    }
    const Eigen::Vector3f to_middle = object.box.center - place.center;
    const float off_center = (to_middle - normal * to_middle.dot(normal)).norm();
    const float cosine = -normal.dot(approach);
    const SuctionPatch& seen = place.seen;
    ScoredGrasp scored;
    scored.family = GraspFamily::kSuction;
    scored.terms = of_object;
    GraspTerms& t = scored.terms;
    t[kTermUnevenness] = std::min(4.0F, seen.unevenness_m / noise);
    t[kTermCurvature] = std::min(4.0F, place.curvature_per_m / cup.max_curvature_per_m);
    t[kTermTilt] = std::sqrt(std::max(0.0F, 1 - cosine * cosine));
    t[kTermOffCenter] = std::min(4.0F, off_center / cup.diameter_m);
    t[kTermCovered] = seen.covered;
    t[kTermTubeGap] = kCentimetres * gap;
    t[kTermPoints] = std::min(2.0F, static_cast<float>(seen.num_points) / 100);
    t[kTermDisagrees] = normal.cross(seen.normal).norm();
    t[kTermEvenReach] = EvenReach(object, solid, grid.frame, place, cup);
    t[kTermInside] = place.is_inside ? 1 : 0;
    if (t[kTermEvenReach] < 1) failures.Add(NoGrasp::Reason::kNoSeal);  // over an edge
    Grasp& grasp = scored.grasp;
    grasp.kind = Grasp::Kind::kSuction;
    grasp.gripper = index;
    grasp.tool_center_point = place.center;
    grasp.approach = -normal;
    grasp.closing = normal.unitOrthogonal();
    grasp.pre_grasp_distance_m = back_m;
    grasp.clearance_m = gap;
    grasp.unevenness_m = seen.unevenness_m;
    grasp.unseen_contacts = object.depth_missing ? 1 : 1 - seen.covered;
    grasp.off_center_m = off_center;
    const WidestCup widest = WidestAt(scene, object, solid, grid.frame, place, cup, noise);
    grasp.usable_diameter_m = widest.on_whole * cup.diameter_m;
    // The model was fitted to what is seen.
    const float wider_m = widest.on_seen * cup.diameter_m - cup.diameter_m;
    t[kTermUsable] = std::min(2.0F, kCentimetres * wider_m / 2);
    grasps.push_back(scored);
  }
  return grasps;
}

}  // namespace fovea
