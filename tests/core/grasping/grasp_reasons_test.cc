// What is said of simple things on a floor that a gripper cannot take.
#include <gtest/gtest.h>

#include "core/grasping/plan_grasps.h"
#include "tests/core/shape/things_on_floor.h"

namespace fovea {
namespace {

using Reason = NoGrasp::Reason;
using scenes::ShapeKind;

// Of the first of some things; none where it has grasps.
std::optional<Reason> ReasonAgainst(const std::vector<scenes::Body>& things, Gripper gripper,
                                    bool is_level = false) {
  ThingsOnFloor scene = CompleteThings(things, 45);
  Detections& found = scene.detections;
  const Eigen::Vector3f up = -found.gravity.direction;
  const Eigen::Vector3f ahead = Eigen::Vector3f::UnitZ();
  if (is_level) gripper.approach = (ahead - up * up.dot(ahead)).normalized();
  PlanGrasps({scene.points, found.labels, scene.frame.intrinsics, up}, {gripper}, found.objects);
  const DetectedObject& object = found.objects[0];
  return object.no_grasps.empty() ? std::nullopt : std::optional(object.no_grasps[0].reason);
}

Gripper WideJaw(float finger_length_m = 0.04F) {
  JawGripper jaw;
  jaw.max_opening_m = 0.14F;
  jaw.finger_length_m = finger_length_m;
  Gripper gripper;
  gripper.hand = jaw;
  return gripper;
}

Gripper CupThatIsWide(float diameter_m) {
  SuctionGripper cup;
  cup.diameter_m = diameter_m;
  Gripper gripper;
  gripper.hand = cup;
  gripper.max_tilt_rad = 0.7F;
  return gripper;
}

TEST(GraspReasons, ATopThatIsTooSmallForACupIsNoSlope) {
  // Its front, which is out of reach, is wide enough.
  for (const double yaw_rad : {0.0, std::numbers::pi / 2}) {
    const scenes::Body board = Thing(ShapeKind::kBox, {0.03, 0.2, 0.2}, {0, 0}, 0, yaw_rad);
    EXPECT_EQ(ReasonAgainst({board}, CupThatIsWide(0.05F)), Reason::kNoSeal) << yaw_rad;
  }
}

TEST(GraspReasons, WhatStandsOnATopCoversItFromACup) {
  const scenes::Body below = Thing(ShapeKind::kBox, {0.1, 0.1, 0.06}, {0, 0}, 0);
  const scenes::Body above = Thing(ShapeKind::kBox, {0.1, 0.1, 0.06}, {0, 0}, 0.06);
  EXPECT_EQ(ReasonAgainst({below, above}, CupThatIsWide(0.03F)), Reason::kCovered);
}

TEST(GraspReasons, ALevelHandMeetsTheFloorOfWhatIsFlat) {
  const scenes::Body flat = Thing(ShapeKind::kBox, {0.06, 0.06, 0.02}, {0, 0}, 0);
  EXPECT_EQ(ReasonAgainst({flat}, WideJaw(), true), Reason::kTooLow);
  const scenes::Body high = Thing(ShapeKind::kBox, {0.06, 0.06, 0.1}, {0, 0}, 0);
  EXPECT_EQ(ReasonAgainst({high}, WideJaw(), true), std::nullopt);
}

TEST(GraspReasons, FingersThatAreTooShortDoNotReachTheFloor) {
  const scenes::Body can = Thing(ShapeKind::kCylinder, {0.06, 0.06, 0.14}, {0, 0}, 0);
  EXPECT_EQ(ReasonAgainst({can}, WideJaw(0.003F)), Reason::kUnlikely);
  const scenes::Body plate = Thing(ShapeKind::kBox, {0.1, 0.1, 0.005}, {0, 0}, 0);
  EXPECT_EQ(ReasonAgainst({plate}, WideJaw()), Reason::kTooLow);
}

}  // namespace
}  // namespace fovea
