#include "core/relations/leans_on.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/relations/blocked_by.h"

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
}

TEST(LeansOn, NothingThatIsNotFlat) {
  DetectedObject rough = Face(25);
  for (std::size_t i = 0; i < rough.cloud.size(); i += 2) rough.cloud[i].z += 0.03F;
  EXPECT_TRUE(Find({rough, Box(0.87F)})[0].leans_on.empty());
}

TEST(LeansOn, WhatLeansMustGoFirst) {
  auto objects = Find({Face(25), Box(0.87F)});
  BlockByWhatStandsOn(objects);
  EXPECT_TRUE(objects[0].blocked_by.empty());
  EXPECT_EQ(objects[1].blocked_by, std::vector<int>{1});
}

}  // namespace
}  // namespace fovea
