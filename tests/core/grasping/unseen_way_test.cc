// What is seen of a hand's way: counted by hand before a wall, and what it makes of grasps.
#include "core/grasping/unseen_way.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/grasping/plan_grasps.h"
#include "core/types/projection.h"
#include "tests/core/shape/things_on_floor.h"

namespace fovea {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// A hand that comes down, in the image, to a place 1 m before the camera; a wall is 2 m away. At 1
// m a pixel is 2 mm, so that the palm, 105 mm wide, is seen in 53 columns, and what it passes, from
// 40 to 230 mm above the tool centre point, in 95 rows.
struct BeforeAWall {
  static constexpr int kObject = 1;

  UnseenWay Look(const Gripper& gripper = {}) const {
    const cv::Mat points(measured.size(), CV_32FC3, cv::Scalar::all(kNone));
    return LookAtWay({points, labels, intrinsics, -Eigen::Vector3f::UnitY(), measured}, kObject,
                     gripper, grasp);
  }
  // Rows that many millimetres above the tool centre point.
  cv::Range Above(int low_mm, int high_mm) const {
    const int row = cvRound(grasp.tool_center_point.y() * 500) + 240;
    return {row - high_mm / 2, row - low_mm / 2};
  }

  Grasp grasp = [] {
    Grasp down;
    down.tool_center_point = {0, 0.1F, 1};
    down.approach = Eigen::Vector3f::UnitY();
    return down;
  }();
  CameraIntrinsics intrinsics{500, 500, 320, 240};
  cv::Mat measured{480, 640, CV_32FC1, cv::Scalar(2)};
  cv::Mat labels = cv::Mat::zeros(480, 640, CV_16UC1);
};

TEST(UnseenWay, NothingIsUnseenBeforeAWall) {
  const BeforeAWall scene;
  EXPECT_EQ(scene.Look().unseen, 0);
  EXPECT_EQ(scene.Look().hidden, 0);
}

TEST(UnseenWay, ABoardInFrontOfItHidesIt) {
  BeforeAWall scene;
  scene.measured.rowRange(scene.Above(120, 160)).setTo(0.7F);
  EXPECT_EQ(scene.Look().unseen, 1);
  EXPECT_EQ(scene.Look().hidden, 1);
  // Two of five columns.
  scene.measured.colRange(313, 640).setTo(2);
  EXPECT_FLOAT_EQ(scene.Look().unseen, 0.4F);
  EXPECT_FLOAT_EQ(scene.Look().hidden, 0.4F);
}

TEST(UnseenWay, WhatHasNoDepthHidesNothing) {
  BeforeAWall scene;
  scene.measured.rowRange(scene.Above(120, 160)).setTo(kNone);
  EXPECT_EQ(scene.Look().unseen, 1);
  EXPECT_EQ(scene.Look().hidden, 0);
}

TEST(UnseenWay, NorDoesTheObjectItself) {
  BeforeAWall scene;
  scene.measured.rowRange(scene.Above(40, 80)).setTo(0.7F);
  scene.labels.rowRange(scene.Above(40, 80)).setTo(BeforeAWall::kObject);
  EXPECT_EQ(scene.Look().unseen, 1);
  EXPECT_EQ(scene.Look().hidden, 0);
}

TEST(UnseenWay, OutsideOfTheImageNobodySees) {
  BeforeAWall scene;
  scene.grasp.tool_center_point.y() = -0.4F;
  EXPECT_EQ(scene.Look().unseen, 1);
  EXPECT_EQ(scene.Look().hidden, 0);
}

TEST(UnseenWay, FromWhereTheWayBeginsOnNothingCounts) {
  BeforeAWall scene;
  scene.measured.rowRange(scene.Above(240, 260)).setTo(0.7F);
  EXPECT_EQ(scene.Look().unseen, 0);
  scene.grasp.pre_grasp_distance_m = 0.2F;
  EXPECT_EQ(scene.Look().unseen, 1);
  // Of a cup 0.15 m, from 4 cm on.
  Gripper cup;
  cup.hand = SuctionGripper{};
  scene.grasp.pre_grasp_distance_m = 0.1F;
  EXPECT_EQ(scene.Look(cup).unseen, 0);
  scene.measured.rowRange(scene.Above(152, 220)).setTo(0.7F);
  scene.measured.rowRange(scene.Above(0, 38)).setTo(0.7F);
  EXPECT_EQ(scene.Look(cup).unseen, 0);
  scene.measured.rowRange(scene.Above(100, 140)).setTo(0.7F);
  EXPECT_EQ(scene.Look(cup).unseen, 1);
}

// A box on a floor; a bar nearer to the camera hides, if it is there, what is above the box.
DetectedObject BoxBehindABar(bool has_bar, float min_probability) {
  ThingsOnFloor scene =
      CompleteThings({Thing(scenes::ShapeKind::kBox, {0.12, 0.06, 0.1}, {0, 0}, 0, 0.2)}, 30);
  Detections& found = scene.detections;
  if (has_bar) {
    const int top = found.objects[0].bounds_px.y;
    for (int row = std::max(0, top - 80); row < top - 30; ++row) {
      for (int column = 0; column < scene.points.cols; ++column) {
        const Eigen::Vector3f at = 0.4F * RayOf({column, row}, scene.frame.intrinsics);
        scene.points.at<cv::Vec3f>(row, column) = {at.x(), at.y(), at.z()};
      }
    }
  }
  Gripper gripper;
  gripper.hand = JawGripper{};
  gripper.min_probability = min_probability;
  PlanGrasps({scene.points, found.labels, scene.frame.intrinsics, -found.gravity.direction},
             {gripper}, found.objects);
  return found.objects[0];
}

TEST(UnseenWay, AHandDoesNotPassBehindABar) {
  const DetectedObject free = BoxBehindABar(false, 0.5F);
  ASSERT_FALSE(free.grasps.empty());
  EXPECT_LT(free.grasps[0].unseen_way, 0.5F);
  const DetectedObject hidden = BoxBehindABar(true, 0.5F);
  EXPECT_TRUE(hidden.grasps.empty());
  ASSERT_EQ(hidden.no_grasps.size(), 1U);
  EXPECT_EQ(hidden.no_grasps[0].reason, NoGrasp::Reason::kCovered);
}

TEST(UnseenWay, WhoAsksForUnlikelyGraspsHasThemAllTheSame) {
  const DetectedObject hidden = BoxBehindABar(true, 0);
  ASSERT_FALSE(hidden.grasps.empty());
  for (const Grasp& grasp : hidden.grasps) {
    EXPECT_LE(grasp.probability, 0.1F);
    EXPECT_EQ(grasp.unseen_way, 1);
  }
}

}  // namespace
}  // namespace fovea
