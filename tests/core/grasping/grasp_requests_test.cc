// What the planner makes of what a request and an object say of themselves.
#include <gtest/gtest.h>

#include "core/grasping/plan_grasps.h"
#include "tests/core/shape/things_on_floor.h"

namespace fovea {
namespace {

using scenes::ShapeKind;

Gripper FingersThatOpen(float opening_m, float friction = 0.5F) {
  JawGripper jaw;
  jaw.max_opening_m = opening_m;
  jaw.friction = friction;
  Gripper gripper;
  gripper.hand = jaw;
  gripper.max_grasps = 20;
  return gripper;
}

// The grasps of a thing by the first of some grippers.
std::vector<Grasp> GraspsOf(const scenes::Body& thing, const std::vector<Gripper>& grippers,
                            bool depth_missing = false) {
  ThingsOnFloor scene = CompleteThings({thing}, 45);
  Detections& found = scene.detections;
  found.objects[0].depth_missing = depth_missing;
  PlanGrasps({scene.points, found.labels, scene.frame.intrinsics, -found.gravity.direction},
             grippers, found.objects);
  std::vector<Grasp> grasps = found.objects[0].grasps;
  std::erase_if(grasps, [](const Grasp& grasp) { return grasp.gripper > 0; });
  return grasps;
}

TEST(GraspRequests, WhatIsSmoothIsNotHeldWhereItSlopes) {
  // Wider than the hand, which takes it above its middle.
  const scenes::Body ball = Thing(ShapeKind::kSphere, {0.089, 0.089, 0.089}, {0, 0}, 0);
  EXPECT_FALSE(GraspsOf(ball, {FingersThatOpen(0.085F)}).empty());
  EXPECT_TRUE(GraspsOf(ball, {FingersThatOpen(0.085F, 0.25F)}).empty());
  const scenes::Body box = Thing(ShapeKind::kBox, {0.1, 0.06, 0.1}, {0, 0}, 0);
  EXPECT_FALSE(GraspsOf(box, {FingersThatOpen(0.085F, 0.25F)}).empty());
}

TEST(GraspRequests, NothingIsSeenAndLittleSureWithoutDepth) {
  const scenes::Body box = Thing(ShapeKind::kBox, {0.1, 0.06, 0.1}, {0, 0}, 0);
  const auto grasps = GraspsOf(box, {FingersThatOpen(0.14F)}, true);
  EXPECT_FALSE(grasps.empty());
  for (const Grasp& grasp : grasps) {
    EXPECT_EQ(grasp.unseen_contacts, 1);
    EXPECT_LE(grasp.probability, 0.6F);
  }
}

TEST(GraspRequests, AMuchWiderHandBesideItChangesNothing) {
  const scenes::Body box = Thing(ShapeKind::kBox, {0.1, 0.06, 0.1}, {0, 0}, 0, 0.4);
  const Gripper jaw = FingersThatOpen(0.085F);
  const auto alone = GraspsOf(box, {jaw});
  const auto beside = GraspsOf(box, {jaw, FingersThatOpen(1)});
  ASSERT_EQ(alone.size(), beside.size());
  ASSERT_FALSE(alone.empty());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(alone[i].tool_center_point, beside[i].tool_center_point);
    EXPECT_EQ(alone[i].probability, beside[i].probability);
  }
}

}  // namespace
}  // namespace fovea
