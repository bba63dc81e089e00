// Simple things before an ideal camera, with their true masks.
#include "core/shape/complete_objects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/shape/things_on_floor.h"

namespace fovea {
namespace {

using scenes::ShapeKind;

void ExpectSize(const DetectedObject& object, const Eigen::Vector3f& size_m) {
  constexpr float kExact_m = 0.004F;  // some two pixels
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(object.box.size_m[axis], size_m[axis], kExact_m) << "axis " << axis;
  }
}

TEST(CompleteObjects, OfABoxTheSidesThatAreHidden) {
  const Detections found =
      CompleteThings({Thing(ShapeKind::kBox, {0.2, 0.12, 0.15}, {0, 0}, 0, 0.5)}, 35).detections;
  const DetectedObject& box = found.objects[0];
  EXPECT_EQ(box.shape.kind, Shape::Kind::kBox);
  ExpectSize(box, {0.2F, 0.12F, 0.15F});
  EXPECT_FALSE(box.yaw_is_arbitrary);
  EXPECT_EQ(box.stands_on, std::vector<int>{0});
  // Two sides of five are hidden.
  const float sides = 2 * 0.15F * 0.32F, all = sides + 0.2F * 0.12F;
  EXPECT_NEAR(box.unseen_share, sides / 2 / all, 0.08F);
}

TEST(CompleteObjects, OfRoundThingsTheBack) {
  const Detections found =
      CompleteThings({Thing(ShapeKind::kSphere, {0.1, 0.1, 0.1}, {-0.2, 0}, 0),
                      Thing(ShapeKind::kCylinder, {0.07, 0.07, 0.12}, {0, 0}, 0),
                      Thing(ShapeKind::kBowl, {0.16, 0.16, 0.06}, {0.2, 0}, 0, 0, 0.005)},
                     35)
          .detections;
  EXPECT_EQ(found.objects[0].shape.kind, Shape::Kind::kSphere);
  ExpectSize(found.objects[0], {0.1F, 0.1F, 0.1F});
  EXPECT_NEAR(found.objects[0].shape.radius_m, 0.05F, 0.002F);
  EXPECT_EQ(found.objects[1].shape.kind, Shape::Kind::kCylinder);
  ExpectSize(found.objects[1], {0.07F, 0.07F, 0.12F});
  EXPECT_GT(found.objects[1].shape.axis.dot(-found.gravity.direction), 0.999F);
  EXPECT_EQ(found.objects[2].shape.kind, Shape::Kind::kRevolution);
  EXPECT_TRUE(found.objects[2].shape.hollow);
  EXPECT_NEAR(found.objects[2].box.size_m.x(), 0.16F, 0.01F);
  for (const DetectedObject& object : found.objects) {
    EXPECT_TRUE(object.yaw_is_arbitrary);
    // Level, and away from the camera.
    EXPECT_GT(object.box.rotation.col(0).z(), 0.5F);
    EXPECT_NEAR(object.box.rotation.col(0).dot(found.gravity.direction), 0, 1e-3F);
  }
}

TEST(CompleteObjects, ACupIsHollowAndACanIsNotHoweverSteep) {
  for (const double pitch_deg : {20.0, 35.0, 60.0}) {
    SCOPED_TRACE(pitch_deg);
    const Detections found =
        CompleteThings({Thing(ShapeKind::kCup, {0.08, 0.08, 0.09}, {-0.1, 0}, 0, 0, 0.004),
                        Thing(ShapeKind::kCylinder, {0.08, 0.08, 0.09}, {0.1, 0}, 0)},
                       pitch_deg)
            .detections;
    EXPECT_EQ(found.objects[0].shape.kind, Shape::Kind::kRevolution);
    EXPECT_TRUE(found.objects[0].shape.hollow);
    EXPECT_EQ(found.objects[1].shape.kind, Shape::Kind::kCylinder);
    EXPECT_FALSE(found.objects[1].shape.hollow);
    for (const DetectedObject& object : found.objects) ExpectSize(object, {0.08F, 0.08F, 0.09F});
  }
}

TEST(CompleteObjects, SeenFromAboveAThingReachesDownToTheFloor) {
  const Detections found =
      CompleteThings({Thing(ShapeKind::kBox, {0.1, 0.08, 0.2}, {0, 0}, 0)}, 89).detections;
  EXPECT_LT(found.objects[0].visible_box.size_m.z(), 0.05F);
  ExpectSize(found.objects[0], {0.1F, 0.08F, 0.2F});
}

TEST(CompleteObjects, AThingStandsOnTheOneBelowIt) {
  const Detections found =
      CompleteThings({Thing(ShapeKind::kCylinder, {0.06, 0.06, 0.08}, {0, 0}, 0.1),
                      Thing(ShapeKind::kBox, {0.2, 0.2, 0.1}, {0, 0}, 0),
                      Thing(ShapeKind::kBox, {0.05, 0.05, 0.05}, {0.25, 0}, 0)},
                     40)
          .detections;
  EXPECT_EQ(found.objects[0].stands_on, std::vector<int>{2});
  ExpectSize(found.objects[0], {0.06F, 0.06F, 0.08F});
  EXPECT_EQ(found.objects[1].stands_on, std::vector<int>{0});
  EXPECT_EQ(found.objects[2].stands_on, std::vector<int>{0});
}

TEST(CompleteObjects, AFlatThingIsFlat) {
  const Detections found =
      CompleteThings({Thing(ShapeKind::kBox, {0.2, 0.14, 0.015}, {0, 0}, 0, 0.3)}, 50).detections;
  EXPECT_EQ(found.objects[0].shape.kind, Shape::Kind::kFlat);
  ExpectSize(found.objects[0], {0.2F, 0.14F, 0.015F});
}

}  // namespace
}  // namespace fovea
