#include "tests/evaluation/clean_up/floor_world.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "tests/support/environment.h"

namespace fovea::evaluation {
namespace {

using Eigen::Vector3d;

scenes::Body Box(const std::string& name, const Vector3d& size_m, const Vector3d& center) {
  scenes::Body body;
  body.name = name;
  body.shape.size_m = size_m;
  body.world_from_body.translation() = center;
  body.is_object = true;
  return body;
}

// On a floor at z = 0, seen from 1 m straight above the origin.
FloorWorld WorldOf(const std::vector<scenes::Body>& things) {
  scenes::Scene scene;
  scene.camera.world_from_camera = scenes::LookAt({0, 0, 0}, 1, std::numbers::pi / 2, 0, 0);
  scene.bodies = {scenes::Block("floor", {0, 0, -0.05}, {4, 4, 0.1}, {})};
  scene.bodies.insert(scene.bodies.end(), things.begin(), things.end());
  Gripper jaw, cup;
  jaw.hand = JawGripper{};
  cup.hand = SuctionGripper{};
  return {scene, {jaw, cup}, scenes::SensorKind::kIdeal, 1};
}

// Straight down, closing along x, given in the world's frame.
Grasp Down(const FloorWorld& world, const Vector3d& tip, float opening_m, std::size_t gripper = 0) {
  const Eigen::Isometry3f camera_from_world =
      world.scene().camera.world_from_camera.inverse().cast<float>();
  Grasp grasp;
  grasp.gripper = gripper;
  grasp.tool_center_point = camera_from_world * tip.cast<float>();
  grasp.approach = camera_from_world.linear() * -Eigen::Vector3f::UnitZ();
  grasp.closing = camera_from_world.linear() * Eigen::Vector3f::UnitX();
  grasp.opening_m = opening_m;
  return grasp;
}

const scenes::Body kLow = Box("low", {0.05, 0.08, 0.06}, {0, 0, 0.03});
const scenes::Body kTall = Box("tall", {0.05, 0.08, 0.2}, {0.3, 0, 0.1});

TEST(FloorWorld, WhatIsHeldIsGone) {
  FloorWorld world = WorldOf({kLow, kTall});
  const Attempt attempt = world.Take(Down(world, {0, 0, 0.03}, 0.05F));
  EXPECT_TRUE(attempt.TookIt());
  EXPECT_EQ(attempt.name, "low");
  ASSERT_EQ(world.NumThings(), 1U);
  EXPECT_EQ(world.Look().objects.front().name, "tall");
  EXPECT_TRUE(world.Take(Down(world, {0.3, 0, 0.2}, 0, 1)).TookIt());
  EXPECT_EQ(world.NumThings(), 0U);
}

TEST(FloorWorld, WhatIsHitTipsOverIfItIsTall) {
  FloorWorld world = WorldOf({kLow, kTall});
  const Attempt low = world.Take(Down(world, {0, 0, 0.03}, 0.01F));
  EXPECT_EQ(low.outcome, Outcome::kHitsTarget);
  EXPECT_FALSE(low.tipped);
  const Attempt tall = world.Take(Down(world, {0.3, 0, 0.18}, 0.01F));
  EXPECT_EQ(tall.outcome, Outcome::kHitsTarget);
  EXPECT_TRUE(tall.tipped);
  ASSERT_EQ(world.NumThings(), 2U);
  // Along the way the fingers close, on the floor where it stood.
  const auto [bottom, top] = VerticalExtent(*ObjectsOf(world.scene())[1]);
  EXPECT_NEAR(bottom, 0, 1e-9);
  EXPECT_NEAR(top, 0.05, 1e-9);
  EXPECT_NEAR(ObjectsOf(world.scene())[1]->world_from_body.translation().x(), 0.4, 1e-9);
}

TEST(FloorWorld, ThereMustBeRoomToTipOver) {
  const scenes::Body left = Box("left", {0.04, 0.2, 0.1}, {0.2, 0, 0.05});
  const scenes::Body right = Box("right", {0.04, 0.2, 0.1}, {0.4, 0, 0.05});
  FloorWorld world = WorldOf({kTall, left, right});
  EXPECT_FALSE(world.Take(Down(world, {0.3, 0, 0.18}, 0.01F)).tipped);
}

TEST(FloorWorld, WhatCarriesAnotherStays) {
  const scenes::Body above = Box("above", {0.03, 0.03, 0.03}, {0, 0.02, 0.075});
  FloorWorld world = WorldOf({kLow, above});
  EXPECT_TRUE(world.CarriesAnother(1));
  EXPECT_FALSE(world.CarriesAnother(2));
  const Attempt attempt = world.Take(Down(world, {0, -0.03, 0.05}, 0.05F));
  EXPECT_EQ(attempt.outcome, Outcome::kSuccess);
  EXPECT_TRUE(attempt.carried);
  EXPECT_FALSE(attempt.TookIt());
  EXPECT_EQ(world.NumThings(), 2U);
  EXPECT_TRUE(world.Take(Down(world, {0, 0.02, 0.075}, 0.03F)).TookIt());
  EXPECT_FALSE(world.CarriesAnother(1));
}

TEST(FloorWorld, AHandMayCloseOnNothing) {
  FloorWorld world = WorldOf({kLow});
  const Attempt attempt = world.Take(Down(world, {0.5, 0.5, 0.03}, 0.05F));
  EXPECT_EQ(attempt.outcome, Outcome::kNoContact);
  EXPECT_EQ(attempt.name, "");
  EXPECT_THROW(world.Take(Down(world, {0, 0, 0.03}, 0.05F, 2)), std::invalid_argument);
}

TEST(FloorWorld, KnowsWhatNoHandTakes) {
  const scenes::Body wall = Box("wall", {0.4, 0.4, 0.06}, {0, 0, 0.03});
  EXPECT_TRUE(WorldOf({kLow}).CanBeTaken(1));
  EXPECT_TRUE(WorldOf({wall}).CanBeTaken(1));  // by the cup
  const scenes::Body lid = Box("lid", {0.4, 0.4, 0.02}, {0, 0, 0.07});
  EXPECT_FALSE(WorldOf({wall, lid}).CanBeTaken(1));
}

TEST(FloorWorld, TheSameSeedMakesTheSameFloor) {
  const scenes::Scene a = ClutteredFloor(3, 4), b = ClutteredFloor(3, 4);
  ASSERT_EQ(ObjectsOf(a).size(), 4U);
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    EXPECT_EQ(a.bodies[i].name, b.bodies[i].name);
    EXPECT_TRUE(a.bodies[i].world_from_body.isApprox(b.bodies[i].world_from_body, 0));
  }
}

}  // namespace
}  // namespace fovea::evaluation
