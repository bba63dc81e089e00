// Simple things before an ideal camera, with their true masks.
#include "core/shape/complete_objects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/depth/back_projection.h"
#include "core/objects/oriented_box.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_objects.h"

namespace fovea {
namespace {

using scenes::Body;
using scenes::ShapeKind;

Body Thing(ShapeKind kind, const Eigen::Vector3d& size_m, const Eigen::Vector2d& at, double on_m,
           double yaw_rad = 0, double wall_m = 0) {
  Body body;
  body.name = "thing";
  body.shape = {kind, size_m, wall_m, {}};
  body.material.color = {0.5, 0.1, 0.1};
  body.is_object = true;
  scenes::Rest(body, at, on_m, yaw_rad);
  return body;
}

// On a floor, seen from 0.9 m away and this high up.
Detections Complete(const std::vector<Body>& things, double pitch_deg) {
  scenes::Scene scene;
  Body floor = Thing(ShapeKind::kBox, {4, 4, 0.1}, {0, 0}, -0.1);
  floor.is_object = false;
  floor.material.color = {0.6, 0.6, 0.6};
  scene.bodies = {floor};
  scene.bodies.insert(scene.bodies.end(), things.begin(), things.end());
  scene.camera.world_from_camera =
      scenes::LookAt({0, 0, 0.05}, 0.9, pitch_deg * std::numbers::pi / 180, 0, 0);
  scene.supports = {{0, {0, 0}, {2, 2}}};
  const scenes::LabelledFrame labelled = MakeFrame(scene, scenes::SensorKind::kIdeal, 1);

  Detections detections;
  detections.gravity.direction = labelled.gravity;
  detections.labels = labelled.labels;
  const cv::Mat points = BackProject(labelled.frame.depth_m, labelled.frame.intrinsics, 10);
  const SupportSurface& support = labelled.supports.front();
  for (std::size_t i = 0; i < things.size(); ++i) {
    DetectedObject& object = detections.objects.emplace_back();
    object.label = static_cast<int>(i) + 1;
    std::vector<Eigen::Vector3f> positions;
    std::vector<cv::Point> pixels;
    cv::findNonZero(labelled.labels == object.label, pixels);
    for (const cv::Point& pixel : pixels) {
      const cv::Vec3f& p = points.at<cv::Vec3f>(pixel);
      object.cloud.push_back({p[0], p[1], p[2]});
      positions.emplace_back(p[0], p[1], p[2]);
      object.centroid += positions.back() / static_cast<float>(pixels.size());
    }
    object.bounds_px = cv::boundingRect(pixels);
    object.visible_box = FitOrientedBox(positions, support.normal, support);
    object.box = object.visible_box;
  }
  CompleteObjects(labelled.frame, points,
                  std::vector<std::optional<SupportSurface>>(things.size(), support), detections);
  return detections;
}

void ExpectSize(const DetectedObject& object, const Eigen::Vector3f& size_m) {
  constexpr float kExact_m = 0.004F;  // some two pixels
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(object.box.size_m[axis], size_m[axis], kExact_m) << "axis " << axis;
  }
}

TEST(CompleteObjects, OfABoxTheSidesThatAreHidden) {
  const Detections found =
      Complete({Thing(ShapeKind::kBox, {0.2, 0.12, 0.15}, {0, 0}, 0, 0.5)}, 35);
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
      Complete({Thing(ShapeKind::kSphere, {0.1, 0.1, 0.1}, {-0.2, 0}, 0),
                Thing(ShapeKind::kCylinder, {0.07, 0.07, 0.12}, {0, 0}, 0),
                Thing(ShapeKind::kBowl, {0.16, 0.16, 0.06}, {0.2, 0}, 0, 0, 0.005)},
               35);
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

TEST(CompleteObjects, SeenFromAboveAThingReachesDownToTheFloor) {
  const Detections found = Complete({Thing(ShapeKind::kBox, {0.1, 0.08, 0.2}, {0, 0}, 0)}, 89);
  EXPECT_LT(found.objects[0].visible_box.size_m.z(), 0.05F);
  ExpectSize(found.objects[0], {0.1F, 0.08F, 0.2F});
}

TEST(CompleteObjects, AThingStandsOnTheOneBelowIt) {
  const Detections found = Complete({Thing(ShapeKind::kCylinder, {0.06, 0.06, 0.08}, {0, 0}, 0.1),
                                     Thing(ShapeKind::kBox, {0.2, 0.2, 0.1}, {0, 0}, 0),
                                     Thing(ShapeKind::kBox, {0.05, 0.05, 0.05}, {0.25, 0}, 0)},
                                    40);
  EXPECT_EQ(found.objects[0].stands_on, std::vector<int>{2});
  ExpectSize(found.objects[0], {0.06F, 0.06F, 0.08F});
  EXPECT_EQ(found.objects[1].stands_on, std::vector<int>{0});
  EXPECT_EQ(found.objects[2].stands_on, std::vector<int>{0});
}

TEST(CompleteObjects, AFlatThingIsFlat) {
  const Detections found =
      Complete({Thing(ShapeKind::kBox, {0.2, 0.14, 0.015}, {0, 0}, 0, 0.3)}, 50);
  EXPECT_EQ(found.objects[0].shape.kind, Shape::Kind::kFlat);
  ExpectSize(found.objects[0], {0.2F, 0.14F, 0.015F});
}

}  // namespace
}  // namespace fovea
