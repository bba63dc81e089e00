#include "tests/evaluation/grasp_check/jaw_check.h"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/support/environment.h"

namespace fovea::evaluation {
namespace {

using Eigen::Vector3d;
using scenes::Body;
using scenes::ShapeKind;

const Vector3d kDown = -Vector3d::UnitZ();
const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY();

Body Object(ShapeKind kind, const Vector3d& size_m, const Vector3d& center, double wall_m = 0) {
  Body body;
  body.name = "object";
  body.shape = {kind, size_m, wall_m, {}};
  body.world_from_body.translation() = center;
  body.is_object = true;
  return body;
}

// On a table whose top is z = 0; the objects are its bodies 1, 2, …
scenes::Scene OnTable(const std::vector<Body>& objects) {
  scenes::Scene scene;
  scene.bodies.push_back(scenes::Block("table", {0, 0, -0.01}, {1, 1, 0.02}, {}));
  scene.bodies.insert(scene.bodies.end(), objects.begin(), objects.end());
  return scene;
}

Outcome Check(const scenes::Scene& scene, const JawPose& pose, int target = 1,
              const JawGripper& gripper = {}) {
  return CheckJaw(PhysicalScene(scene), target, gripper, pose);
}

const Body kBox = Object(ShapeKind::kBox, {0.05, 0.08, 0.06}, {0, 0, 0.03});

TEST(JawCheck, TakesABoxBetweenTheFingers) {
  EXPECT_EQ(Check(OnTable({kBox}), {{0, 0, 0.04}, kDown, kX, 0.05}), Outcome::kSuccess);
  // 80 mm fit into 85, without much room.
  EXPECT_EQ(Check(OnTable({kBox}), {{0, 0, 0.04}, kDown, kY, 0.08}), Outcome::kSuccess);
}

TEST(JawCheck, OpensNoFurtherThanItCan) {
  EXPECT_EQ(Check(OnTable({kBox}), {{0, 0, 0.04}, kDown, kY, 0.09}), Outcome::kTooWide);
  Body wide = kBox;
  wide.shape.size_m.x() = 0.1;
  EXPECT_EQ(Check(OnTable({wide}), {{0, 0, 0.04}, kDown, kX, 0.08}), Outcome::kHitsTarget);
}

TEST(JawCheck, OpensAsToldWithAMarginOfTenMillimetresOnEachSide) {
  EXPECT_EQ(Check(OnTable({kBox}), {{0, 0, 0.04}, kDown, kX, 0.033}), Outcome::kSuccess);
  EXPECT_EQ(Check(OnTable({kBox}), {{0, 0, 0.04}, kDown, kX, 0.027}), Outcome::kHitsTarget);
  EXPECT_EQ(Check(OnTable({kBox}), {{0.009, 0, 0.04}, kDown, kX, 0.05}), Outcome::kSuccess);
  EXPECT_EQ(Check(OnTable({kBox}), {{0.012, 0, 0.04}, kDown, kX, 0.05}), Outcome::kHitsTarget);
}

TEST(JawCheck, ThePalmReachesDownToTheTargetWhereTheFingersGoTooDeep) {
  EXPECT_EQ(Check(OnTable({kBox}), {{0, 0, 0.022}, kDown, kX, 0.05}), Outcome::kSuccess);
  EXPECT_EQ(Check(OnTable({kBox}), {{0, 0, 0.018}, kDown, kX, 0.05}), Outcome::kHitsTarget);
}

TEST(JawCheck, TouchesNoNeighbor) {
  // The outer side of the finger moves in at x = 25 + 10 + 10 = 45 mm.
  const Body near = Object(ShapeKind::kBox, {0.02, 0.02, 0.03}, {0.053, 0, 0.015});
  const Body beside = Object(ShapeKind::kBox, {0.02, 0.02, 0.03}, {0.056, 0, 0.015});
  const JawPose low = {{0, 0, 0.025}, kDown, kX, 0.05}, high = {{0, 0, 0.035}, kDown, kX, 0.05};
  EXPECT_EQ(Check(OnTable({kBox, near}), low), Outcome::kHitsNeighbor);
  EXPECT_EQ(Check(OnTable({kBox, beside}), low), Outcome::kSuccess);
  EXPECT_EQ(Check(OnTable({kBox, near}), high), Outcome::kSuccess);
  // As high as the palm, whose half width is (85 + 20) / 2 = 52.5 mm.
  const Body tall = Object(ShapeKind::kCylinder, {0.02, 0.02, 0.12}, {0.06, 0, 0.06});
  EXPECT_EQ(Check(OnTable({kBox, tall}), high), Outcome::kHitsNeighbor);
}

TEST(JawCheck, TheSweepMeetsWhatHangsAbove) {
  scenes::Scene scene = OnTable({kBox});
  scene.bodies.push_back(scenes::Block("board", {0, 0, 0.22}, {0.5, 0.5, 0.02}, {}));
  EXPECT_EQ(Check(scene, {{0, 0, 0.04}, kDown, kX, 0.05}), Outcome::kHitsFurniture);
  // From 150 mm before the tips and 80 mm more of finger and palm, it would be at 280 mm.
  scene.bodies.back().world_from_body.translation().z() = 0.3;
  EXPECT_EQ(Check(scene, {{0, 0, 0.04}, kDown, kX, 0.05}), Outcome::kSuccess);
}

TEST(JawCheck, DoesNotReachIntoTheTable) {
  const Body card = Object(ShapeKind::kBox, {0.05, 0.08, 0.004}, {0, 0, 0.002});
  EXPECT_EQ(Check(OnTable({card}), {{0, 0, -0.002}, kDown, kX, 0.05}), Outcome::kHitsFurniture);
  EXPECT_EQ(Check(OnTable({card}), {{0, 0, 0.0005}, kDown, kX, 0.05}), Outcome::kSuccess);
  EXPECT_EQ(Check(OnTable({card}), {{0, 0, 0.006}, kDown, kX, 0.05}), Outcome::kNoContact);
}

TEST(JawCheck, HoldsABallWithinFriction) {
  // The first contact of fingers whose tips are h above the middle of a ball of radius r has a
  // normal that rises by asin(h / r); friction 0.5 holds 26.6°. Rays are 1 mm above the tips.
  const Body ball = Object(ShapeKind::kSphere, {0.07, 0.07, 0.07}, {0, 0, 0.035});
  const auto at = [&](double above_middle_m, double opening_m) {
    return Check(OnTable({ball}), {{0, 0, 0.035 + above_middle_m}, kDown, kX, opening_m});
  };
  EXPECT_EQ(at(0, 0.07), Outcome::kSuccess);
  EXPECT_EQ(at(-0.004, 0.07), Outcome::kSuccess);
  EXPECT_EQ(at(0.012, 0.07), Outcome::kSuccess);
  EXPECT_EQ(at(0.018, 0.07), Outcome::kSlips);
}

TEST(JawCheck, MovesInAsWideAsIsSaid) {
  // 30 mm wide, but what was seen of it only 4 mm: 10 mm more on each side meet it, 15 do not.
  const Body bar = Object(ShapeKind::kBox, {0.03, 0.1, 0.06}, {0, 0, 0.03});
  const auto with = [&](double moving_in_m) {
    return Check(OnTable({bar}), {{0, 0, 0.03}, kDown, kX, 0.004, moving_in_m});
  };
  EXPECT_EQ(with(0), Outcome::kHitsTarget);
  EXPECT_EQ(with(0.024), Outcome::kHitsTarget);
  EXPECT_EQ(with(0.034), Outcome::kSuccess);
}

TEST(JawCheck, SlipsOffACorner) {
  // Across a square turned by 30°: its sides face the fingers at 30°.
  Body turned = kBox;
  turned.shape.size_m = {0.04, 0.04, 0.06};
  turned.world_from_body.linear() =
      Eigen::AngleAxisd(std::numbers::pi / 6, Vector3d::UnitZ()).toRotationMatrix();
  const JawPose pose = {{0, 0, 0.04}, kDown, kX, 0.06};
  EXPECT_EQ(Check(OnTable({turned}), pose), Outcome::kSlips);
  turned.world_from_body.linear() = Eigen::AngleAxisd(0.3, Vector3d::UnitZ()).toRotationMatrix();
  // 17° each, but the corners that the pads meet first are far apart across the hand.
  EXPECT_EQ(Check(OnTable({turned}), pose), Outcome::kSlips);
  turned.world_from_body.linear() = Eigen::AngleAxisd(0.03, Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_EQ(Check(OnTable({turned}), pose), Outcome::kSuccess);
}

TEST(JawCheck, TakesABowlByItsRim) {
  const Body bowl = Object(ShapeKind::kBowl, {0.15, 0.15, 0.055}, {0, 0, 0.0275}, 0.005);
  const auto at = [&](double tip_m) {
    return Check(OnTable({bowl}), {{0.0725, 0, tip_m}, kDown, kX, 0.006});
  };
  EXPECT_EQ(at(0.05), Outcome::kSuccess);
  // The wall grows thicker across the hand, and faces the inner finger at 24° and more.
  EXPECT_EQ(at(0.035), Outcome::kSlips);
  EXPECT_EQ(Check(OnTable({bowl}), {{0, 0, 0.045}, kDown, kX, 0.15}), Outcome::kTooWide);
}

TEST(JawCheck, TakesALyingCylinderAcrossNotAlong) {
  Body tube = Object(ShapeKind::kCylinder, {0.05, 0.05, 0.2}, {0, 0, 0.025});
  tube.world_from_body.linear() =
      Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()).toRotationMatrix();
  EXPECT_EQ(Check(OnTable({tube}), {{0, 0, 0.02}, kDown, kX, 0.05}), Outcome::kSuccess);
  EXPECT_EQ(Check(OnTable({tube}), {{0, 0, 0.02}, kDown, kY, 0.05}), Outcome::kHitsTarget);
}

TEST(JawCheck, MeetsAnotherBodyBeforeTheTarget) {
  // A pencil beside the box, within the opened fingers.
  const Body pencil = Object(ShapeKind::kBox, {0.006, 0.1, 0.006}, {0.029, 0, 0.003});
  const JawPose pose = {{0, 0, 0.001}, kDown, kX, 0.05};
  const Body low = Object(ShapeKind::kBox, {0.05, 0.08, 0.02}, {0, 0, 0.01});
  EXPECT_EQ(Check(OnTable({low, pencil}), pose), Outcome::kOtherBodyFirst);
  EXPECT_EQ(Check(OnTable({low}), pose), Outcome::kSuccess);
}

}  // namespace
}  // namespace fovea::evaluation
