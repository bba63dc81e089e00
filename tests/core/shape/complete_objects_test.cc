// Simple things before an ideal camera, with their true masks.
#include "core/shape/complete_objects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/shape/carriers.h"
#include "core/shape/completed.h"
#include "tests/core/shape/things_on_floor.h"
#include "tests/support/compound_parts.h"

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

TEST(CompleteObjects, ABowlIsWiderHalfWayUpThanAFrustum) {
  const Detections found =
      CompleteThings({Thing(ShapeKind::kBowl, {0.16, 0.16, 0.06}, {0, 0}, 0, 0, 0.004)}, 45)
          .detections;
  const Shape& bowl = found.objects[0].shape;
  ASSERT_EQ(bowl.kind, Shape::Kind::kRevolution);
  ASSERT_EQ(bowl.radii_m.size(), 8U);
  // True: 40 mm at the foot, 66 mm half way up, 80 mm at the rim.
  EXPECT_NEAR((bowl.radii_m[3] + bowl.radii_m[4]) / 2, 0.066F, 0.004F);
  EXPECT_NEAR(bowl.radius_m, 0.08F, 0.003F);
}

// Lies or stands at a place as its parts say.
scenes::Body Placed(std::vector<scenes::Part> parts, double yaw_rad) {
  scenes::Body body = scenes::Compound("thing", std::move(parts));
  body.is_object = true;
  scenes::Rest(body, {0, 0}, 0, yaw_rad);
  return body;
}

TEST(CompleteObjects, AFlatBottleIsOblong) {
  constexpr double kSide_m = 0.025, kDepth_m = 0.05, kHeight_m = 0.14;
  std::vector<scenes::Part> parts = {
      scenes::BlockPart({0, 0, kHeight_m / 2}, {2 * kSide_m, kDepth_m, kHeight_m})};
  for (const double x : {-kSide_m, kSide_m}) {
    parts.push_back(scenes::RodPart({x, 0, 0}, {x, 0, kHeight_m}, kDepth_m));
  }
  const Detections found = CompleteThings({Placed(parts, 0.4)}, 35).detections;
  const DetectedObject& object = found.objects[0];
  EXPECT_EQ(object.shape.kind, Shape::Kind::kOther);
  EXPECT_EQ(object.shape.form, Shape::Form::kOblong);
  ExpectSize(object, {0.1F, 0.05F, 0.14F});
}

// How far its ends lie from its middle along the box's y axis.
float EndsBesideMiddle(const DetectedObject& object) {
  float ends = 0, middle = 0;
  int num_ends = 0, num_middle = 0;
  for (const ColoredPoint& p : object.cloud) {
    const Eigen::Vector3f at =
        object.box.rotation.transpose() * (Eigen::Vector3f(p.x, p.y, p.z) - object.box.center);
    if (std::abs(at.x()) > 0.08F) ends += at.y(), ++num_ends;
    if (std::abs(at.x()) < 0.02F) middle += at.y(), ++num_middle;
  }
  return ends / static_cast<float>(num_ends) - middle / static_cast<float>(num_middle);
}

TEST(CompleteObjects, ABananaIsBent) {
  for (const double side : {-1.0, 1.0}) {
    SCOPED_TRACE(side);
    std::vector<scenes::Part> parts;
    std::vector<Eigen::Vector3d> axis;
    for (int i = -4; i <= 4; ++i) axis.emplace_back(0.02 * i, side * 0.04 * i * i / 16, 0.02);
    scenes::AddBentRod(parts, axis, 0.04);
    for (const Eigen::Vector3d& end : {axis.front(), axis.back()}) {
      parts.push_back(scenes::BallPart(end, 0.04));
    }
    const Detections found = CompleteThings({Placed(parts, 0.3)}, 40).detections;
    const DetectedObject& object = found.objects[0];
    EXPECT_EQ(object.shape.kind, Shape::Kind::kOther);
    EXPECT_EQ(object.shape.form, Shape::Form::kBent);
    ExpectSize(object, {0.2F, 0.08F, 0.04F});
    EXPECT_NEAR(std::abs(object.shape.bend_m), 0.04F, 0.006F);
    EXPECT_GT(object.shape.bend_m * EndsBesideMiddle(object), 0);
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

TEST(CompleteObjects, WhereNoSupportWasFoundNothingStandsOnOne) {
  ThingsOnFloor things =
      CompleteThings({Thing(ShapeKind::kCylinder, {0.06, 0.06, 0.08}, {0, 0}, 0.1),
                      Thing(ShapeKind::kBox, {0.2, 0.2, 0.1}, {0, 0}, 0)},
                     40);
  std::vector<DetectedObject>& objects = things.detections.objects;
  for (DetectedObject& object : objects) object.stands_on.clear();
  CompleteObjects(things.frame, {things.frame.depth_m, things.frame.intrinsics},
                  {std::nullopt, std::nullopt}, things.detections);
  EXPECT_EQ(objects[0].stands_on, std::vector<int>{2});
  EXPECT_EQ(objects[1].stands_on, std::vector<int>());
}

// Its lowest points, as measured, are lower than those of the top of the book, which is all that is
// seen of that.
TEST(CompleteObjects, AThingStandsOnABook) {
  ThingsOnFloor things = CompleteThings({Thing(ShapeKind::kBox, {0.08, 0.08, 0.12}, {0, 0}, 0.02),
                                         Thing(ShapeKind::kBox, {0.25, 0.2, 0.02}, {0, 0}, 0)},
                                        40);
  std::vector<DetectedObject>& objects = things.detections.objects;
  const Eigen::Vector3f up = -things.detections.gravity.direction;
  for (DetectedObject& object : objects) object.stands_on.clear();
  objects[1].visible_box.center += up * (objects[1].visible_box.size_m.z() / 2 - 0.001F);
  objects[1].visible_box.size_m.z() = 0.002F;
  const SupportSurface floor = {up, -HeightAlong(up, objects[1].box, 0), 1000};
  CompleteObjects(things.frame, {things.frame.depth_m, things.frame.intrinsics}, {floor, floor},
                  things.detections);
  EXPECT_EQ(objects[0].stands_on, std::vector<int>{2});
}

TEST(CompleteObjects, ATrayOverhangsTheCanThatIsHiddenBelowIt) {
  const Detections found =
      CompleteThings({Thing(ShapeKind::kCylinder, {0.06, 0.06, 0.12}, {0, 0}, 0),
                      Thing(ShapeKind::kBox, {0.24, 0.18, 0.03}, {0, 0}, 0.12)},
                     35)
          .detections;
  EXPECT_EQ(found.objects[1].stands_on, std::vector<int>{1});
  EXPECT_LT(found.objects[1].box.size_m.z(), 0.06F);
}

TEST(CompleteObjects, ARodLiesOnACanThatIsMuchShorter) {
  const Detections found =
      CompleteThings({Thing(ShapeKind::kCylinder, {0.06, 0.06, 0.1}, {0, 0}, 0),
                      Thing(ShapeKind::kBox, {0.3, 0.03, 0.03}, {0, 0}, 0.1, 0.2)},
                     40)
          .detections;
  EXPECT_EQ(found.objects[1].stands_on, std::vector<int>{1});
}

TEST(CompleteObjects, WhatHangsDownBesideABoxStandsOnIt) {
  constexpr double kHeight_m = 0.12, kHanging_m = 0.036;
  const Eigen::Vector3d hanging_m = {0.01, 0.1, kHanging_m};
  scenes::Body cover =
      scenes::Compound("cover", {scenes::BlockPart({0, 0, 0.01}, {0.22, 0.1, 0.02}),
                                 scenes::BlockPart({-0.106, 0, -kHanging_m / 2}, hanging_m),
                                 scenes::BlockPart({0.106, 0, -kHanging_m / 2}, hanging_m)});
  cover.is_object = true;
  cover.world_from_body.translation().z() = kHeight_m;
  const Detections found =
      CompleteThings({Thing(ShapeKind::kBox, {0.2, 0.3, kHeight_m}, {0, 0}, 0), cover}, 40)
          .detections;
  EXPECT_EQ(found.objects[1].stands_on, std::vector<int>{1});
}

TEST(CompleteObjects, AFlatThingIsFlat) {
  const Detections found =
      CompleteThings({Thing(ShapeKind::kBox, {0.2, 0.14, 0.015}, {0, 0}, 0, 0.3)}, 50).detections;
  EXPECT_EQ(found.objects[0].shape.kind, Shape::Kind::kFlat);
  ExpectSize(found.objects[0], {0.2F, 0.14F, 0.015F});
}

TEST(CompleteObjects, WhatHasNoDepthCarriesAsWell) {
  ThingsOnFloor things =
      CompleteThings({Thing(ShapeKind::kCylinder, {0.06, 0.06, 0.1}, {0, 0}, 0),
                      Thing(ShapeKind::kBox, {0.3, 0.03, 0.03}, {0, 0}, 0.1, 0.2)},
                     40);
  std::vector<DetectedObject>& objects = things.detections.objects;
  objects[0].depth_missing = true;
  for (DetectedObject& object : objects) object.stands_on.clear();
  const Eigen::Vector3f up = -things.detections.gravity.direction;
  const SupportSurface floor = {up, -HeightAlong(up, objects[0].box, 0), 1000};
  CompleteObjects(things.frame, {things.frame.depth_m, things.frame.intrinsics}, {floor, floor},
                  things.detections);
  EXPECT_EQ(objects[1].stands_on, std::vector<int>{1});
}

TEST(SetShape, LeavesNothingOfTheShapeBefore) {
  DetectedObject object;
  object.visible_box.size_m = {0.1F, 0.1F, 0.1F};
  object.yaw_is_arbitrary = true;
  object.shape.kind = Shape::Kind::kRevolution;
  object.shape.hollow = true;
  object.shape.radii_m = {0.05F, 0.06F};
  SetShape(FittedShape{}, FrameUnder(object.visible_box), object);
  EXPECT_EQ(object.shape.kind, Shape::Kind::kOther);
  EXPECT_FALSE(object.shape.hollow);
  EXPECT_TRUE(object.shape.radii_m.empty());
  EXPECT_FALSE(object.yaw_is_arbitrary);
}

}  // namespace
}  // namespace fovea
