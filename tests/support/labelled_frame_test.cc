// Frames against their own ground truth.
#include "tests/support/labelled_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

#include "tests/support/environment.h"
#include "tests/support/random_objects.h"
#include "tests/support/random_scene.h"

namespace fovea::scenes {
namespace {

Eigen::Vector3f PointAt(const RgbdFrame& frame, int x, int y) {
  const CameraIntrinsics& k = frame.intrinsics;
  const float depth = frame.depth_m.at<float>(y, x);
  return depth * Eigen::Vector3d((x - k.cx_px) / k.fx_px, (y - k.cy_px) / k.fy_px, 1).cast<float>();
}

// A ball of 10 cm on a bare floor, in the middle of the image.
Scene BallOnFloor() {
  Scene scene;
  scene.bodies = {Block("floor", {0, 0, -0.5}, {20, 20, 1}, {})};
  scene.supports = {{0, {0, 0}, {5, 5}}};
  Body ball;
  ball.name = "ball";
  ball.shape = {ShapeKind::kSphere, {0.1, 0.1, 0.1}, 0, {}};
  ball.is_object = true;
  Rest(ball, {0, 0}, 0, 0);
  scene.bodies.push_back(ball);
  scene.camera = CameraOfSize({321, 241});  // odd: the middle is the centre of a pixel
  scene.camera.world_from_camera = LookAt({0, 0, 0.05}, 1.0, 0.6, 0.3, 0.1);
  return scene;
}

TEST(LabelledFrame, DepthOfABallIsExact) {
  const LabelledFrame labelled = MakeFrame(BallOnFloor(), SensorKind::kIdeal, 1);
  EXPECT_NEAR(labelled.frame.depth_m.at<float>(120, 160), 1.0 - 0.05, 1e-6);
  EXPECT_EQ(labelled.labels.at<std::uint16_t>(120, 160), 1);
  ASSERT_EQ(labelled.objects.size(), 1U);
  EXPECT_TRUE(labelled.objects[0].camera_from_object.translation().isApprox(
      Eigen::Vector3d(0, 0, 1), 1e-9));
  EXPECT_EQ(labelled.objects[0].num_pixels, cv::countNonZero(labelled.labels == 1));
  const double radius_px = labelled.frame.intrinsics.fx_px * 0.05;  // at 1 m
  EXPECT_NEAR(labelled.objects[0].num_pixels, std::numbers::pi * radius_px * radius_px, 30);
}

TEST(LabelledFrame, PixelsBesideTheObjectLieOnTheSupport) {
  const LabelledFrame labelled = MakeFrame(BallOnFloor(), SensorKind::kIdeal, 1);
  ASSERT_EQ(labelled.supports.size(), 1U);
  int checked = 0;
  for (int y = 100; y < labelled.labels.rows; ++y) {
    for (int x = 0; x < labelled.labels.cols; ++x) {
      const float height = labelled.supports[0].HeightOf(PointAt(labelled.frame, x, y));
      if (labelled.labels.at<std::uint16_t>(y, x) == 0) {
        ASSERT_NEAR(height, 0, 1e-5) << x << ", " << y;
        ++checked;
      } else {
        ASSERT_GT(height, -1e-5) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(checked, 10000);
  EXPECT_TRUE(labelled.gravity.isApprox(-labelled.supports[0].normal));
}

TEST(LabelledFrame, GravityFollowsTheCamerasPitch) {
  Scene scene = BallOnFloor();
  scene.camera.world_from_camera = LookAt({0, 0, 0}, 1, 0.5, 1.2, 0);
  const LabelledFrame labelled = MakeFrame(scene, SensorKind::kIdeal, 1);
  EXPECT_TRUE(labelled.gravity.isApprox(Eigen::Vector3f(0, std::cos(0.5F), std::sin(0.5F)), 1e-6));
}

TEST(LabelledFrame, TheNearerObjectHidesTheOther) {
  Scene scene = BallOnFloor();
  Body wall = Block("screen", {0, 0, 0.3}, {0.6, 0.02, 0.6}, {});
  wall.is_object = true;
  scene.bodies.push_back(wall);
  scene.camera.world_from_camera = LookAt({0, 0.1, 0.05}, 1.0, 0.1, 0, 0);
  const Body ball = scene.bodies[1];
  Rest(scene.bodies[1], {0, 0.2}, 0, 0);
  const LabelledFrame hidden = MakeFrame(scene, SensorKind::kIdeal, 1);
  EXPECT_EQ(hidden.objects[0].num_pixels, 0);
  EXPECT_GT(hidden.objects[1].num_pixels, 1000);
}

TEST(LabelledFrame, SameSeedGivesTheSameBytes) {
  const auto equal = [](const cv::Mat& a, const cv::Mat& b) {
    return a.size() == b.size() && std::equal(a.datastart, a.dataend, b.datastart, b.dataend);
  };
  const auto make = [](std::uint64_t seed) {
    return MakeFrame(RandomScene("cluttered", seed, {160, 120}), SensorKind::kKinect, seed);
  };
  const LabelledFrame first = make(3), again = make(3), other = make(4);
  EXPECT_TRUE(equal(first.frame.color_rgb, again.frame.color_rgb));
  EXPECT_TRUE(equal(first.frame.depth_m, again.frame.depth_m));
  EXPECT_TRUE(equal(first.labels, again.labels));
  EXPECT_FALSE(equal(first.frame.color_rgb, other.frame.color_rgb));
}

}  // namespace
}  // namespace fovea::scenes
