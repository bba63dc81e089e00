#include "core/relations/leans_on.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/relations/blocked_by.h"
#include "core/types/cancelled.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

using Eigen::Vector3f;

// Camera frame: y down, so up is -y; the table is 0.5 m below the camera.
const Vector3f kUp = -Vector3f::UnitY();
constexpr float kTable = 0.5F;

// A face 12 cm wide and 16 cm long, its lower end on the table at z = 0.8, that leans away from the
// camera by this angle from the upright.
DetectedObject Face(float degrees) {
  const float tilt = degrees * std::numbers::pi_v<float> / 180;
  DetectedObject object;
  Vector3f low = Vector3f::Constant(9), high = -low;
  for (int i = 0; i < 13; ++i) {
    for (int j = 0; j < 17; ++j) {
      const float x = 0.01F * static_cast<float>(i - 6), slope = 0.01F * static_cast<float>(j);
      const Vector3f p(x, kTable - slope * std::cos(tilt), 0.8F + slope * std::sin(tilt));
      object.cloud.push_back({p.x(), p.y(), p.z(), 0, 0, 0});
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  object.visible_box.center = (low + high) / 2;
  object.visible_box.rotation.col(0) = Vector3f::UnitX();
  object.visible_box.rotation.col(1) = Vector3f::UnitZ();
  object.visible_box.rotation.col(2) = kUp;
  object.visible_box.size_m = {high.x() - low.x(), high.z() - low.z(), high.y() - low.y()};
  object.box = object.visible_box;
  return object;
}

// On the table, its front at this z.
DetectedObject Box(float front_z, float height_m = 0.15F) {
  DetectedObject object = Face(0);
  object.cloud.resize(10);
  object.box.size_m = {0.2F, 0.1F, height_m};
  object.box.center = {0, kTable - height_m / 2, front_z + 0.05F};
  object.visible_box = object.box;
  return object;
}

std::vector<DetectedObject> Find(std::vector<DetectedObject> objects) {
  for (std::size_t i = 0; i < objects.size(); ++i) objects[i].label = static_cast<int>(i) + 1;
  FindWhatLeans(kUp, objects);
  return objects;
}

TEST(LeansOn, WhatIsBehindTheUpperHalfOfATiltedFace) {
  // 16 cm at 25 degrees: its upper end is 68 mm behind its lower end.
  const auto objects = Find({Face(25), Box(0.87F), Box(1.2F)});
  EXPECT_EQ(objects[0].leans_on, std::vector<int>{2});
  EXPECT_TRUE(objects[1].leans_on.empty());
}

TEST(LeansOn, NothingThatStandsUprightOrLies) {
  EXPECT_TRUE(Find({Face(0), Box(0.81F)})[0].leans_on.empty());
  EXPECT_TRUE(Find({Face(80), Box(0.9F)})[0].leans_on.empty());
}

TEST(LeansOn, NothingFarBehindOrTooLow) {
  EXPECT_TRUE(Find({Face(25), Box(1.0F)})[0].leans_on.empty());
  EXPECT_TRUE(Find({Face(25), Box(0.87F, 0.02F)})[0].leans_on.empty());
  // Behind all of the lower half, and next to nothing of the upper one.
  EXPECT_TRUE(Find({Face(25), Box(0.8F, 0.045F)})[0].leans_on.empty());
  // Its top is hardly above the lower end of what lies over it.
  EXPECT_TRUE(Find({Face(55), Box(0.86F, 0.025F)})[0].leans_on.empty());
}

TEST(LeansOn, OnlyOnWhatHoldsItBest) {
  EXPECT_EQ(Find({Face(25), Box(0.87F), Box(0.87F, 0.08F)})[0].leans_on, std::vector<int>{2});
  EXPECT_EQ(Find({Face(25), Box(0.87F, 0.08F), Box(0.87F)})[0].leans_on, std::vector<int>{3});
}

TEST(LeansOn, NotOnWhatItStandsOn) {
  DetectedObject face = Face(25);
  face.stands_on = {2};
  EXPECT_TRUE(Find({face, Box(0.87F)})[0].leans_on.empty());
}

TEST(LeansOn, NothingThatIsNotFlat) {
  DetectedObject rough = Face(25);
  for (std::size_t i = 0; i < rough.cloud.size(); i += 2) rough.cloud[i].z += 0.03F;
  EXPECT_TRUE(Find({rough, Box(0.87F)})[0].leans_on.empty());
}

// Half of a tent whose ridge points away from the camera, at x = 0: leans to the right (side -1) or
// to the left (1) by 40 degrees, its upper end 2 mm before the ridge.
DetectedObject TentSide(float side) {
  DetectedObject board = Face(40);
  const float reach_m = 0.16F * std::sin(40 * std::numbers::pi_v<float> / 180) + 0.002F;
  const auto turned = [&](const Vector3f& p) {
    return Vector3f(side * (reach_m - (p.z() - 0.8F)), p.y(), 0.9F + side * p.x());
  };
  for (ColoredPoint& p : board.cloud) {
    const Vector3f at = turned({p.x, p.y, p.z});
    p = {at.x(), at.y(), at.z(), 0, 0, 0};
  }
  board.visible_box.center = turned(board.visible_box.center);
  board.visible_box.rotation.col(0) = Vector3f::UnitZ();
  board.visible_box.rotation.col(1) = Vector3f::UnitX();
  board.box = board.visible_box;
  return board;
}

TEST(LeansOn, OfTwoThatHoldEachOtherTheBetterHeldOneLeans) {
  const DetectedObject left = TentSide(-1);
  DetectedObject right = TentSide(1);
  EXPECT_EQ(Find({left, right})[0].leans_on, std::vector<int>{2});  // both are held as well
  EXPECT_TRUE(Find({left, right})[1].leans_on.empty());
  // The box of the left one ends lower now and holds less of the right one.
  DetectedObject low = left;
  low.box.size_m.z() -= 0.06F;
  low.box.center.y() += 0.03F;
  EXPECT_EQ(Find({right, low})[1].leans_on, std::vector<int>{1});
  EXPECT_TRUE(Find({right, low})[0].leans_on.empty());
}

TEST(LeansOn, NothingOnWhatStandsOnItByAnother) {
  std::vector<DetectedObject> pile = {Face(25), Box(0.87F), Box(1.5F)};
  pile[1].stands_on = {3};
  pile[2].stands_on = {1};
  EXPECT_TRUE(Find(pile)[0].leans_on.empty());
  pile[2].stands_on = {0};
  EXPECT_EQ(Find(pile)[0].leans_on, std::vector<int>{2});
}

TEST(LeansOn, WhatLeansMustGoFirst) {
  auto objects = Find({Face(25), Box(0.87F)});
  BlockByWhatStandsOn(objects);
  EXPECT_TRUE(objects[0].blocked_by.empty());
  EXPECT_EQ(objects[1].blocked_by, std::vector<int>{1});
}

TEST(LeansOn, CanBeStopped) {
  const InterruptionScope scope([] { return true; }, std::chrono::microseconds(0));
  EXPECT_THROW(Find({Face(25)}), Cancelled);
}

}  // namespace
}  // namespace fovea
