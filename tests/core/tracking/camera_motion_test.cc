#include "core/tracking/camera_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/tracking/table_view.h"

namespace fovea {
namespace {

using testing::AddAt;
using testing::PoseAt;
using testing::View;
using enum CameraMotionSource;

TEST(CameraPath, TakesTheMotionFromPoses) {
  CameraPath path;
  EXPECT_EQ(AddAt(path, 0, 1, PoseAt(5)).motion.source, kFirstFrame);
  const CameraPath::Place place = AddAt(path, 0, 2, PoseAt(5.25));
  EXPECT_EQ(place.motion.source, kGiven);
  EXPECT_NEAR(place.motion.last_from_this.translation().x(), 0.25, 1e-9);
}

// Turned, so that a product with the position would be rounded, too.
TEST(CameraPath, TakesTheMotionFromPosesFarFromTheirOrigin) {
  for (const double far_m : {1e6, 1e7, 1e9, 5e11}) {
    const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1, 2, 3).normalized());
    const auto pose_at = [&](double x_m) {
      return Eigen::Translation3d(far_m + x_m, -far_m, far_m / 3) * turn;
    };
    CameraPath path;
    AddAt(path, 0, 1, pose_at(0));
    const CameraMotion motion = AddAt(path, 0, 2, pose_at(0.25)).motion;
    ASSERT_EQ(motion.source, kGiven) << far_m;
    const Eigen::Vector3d expected = turn.inverse() * Eigen::Vector3d(0.25, 0, 0);
    EXPECT_LT((motion.last_from_this.translation() - expected).norm(), 1e-6 + 1e-16 * far_m)
        << far_m;
    EXPECT_TRUE(motion.last_from_this.linear().isIdentity(1e-12)) << far_m;
  }
}

TEST(CameraPath, EstimatesTheMotionFromFrames) {
  CameraPath path;
  AddAt(path, 0, 1);
  double x_m = 0;
  for (int i = 1; i <= 5; ++i) {
    const CameraPath::Place place = AddAt(path, 0.04 * i, 1 + i);
    ASSERT_EQ(place.motion.source, kEstimated) << "frame " << i;
    x_m += place.motion.last_from_this.translation().x();
    EXPECT_NEAR(x_m, 0.04 * i, 0.004) << "frame " << i;
    EXPECT_LT(place.error_m, 0.004);
  }
}

TEST(CameraPath, SeesThatTheCameraStandsAndDoesNotDriftThen) {
  CameraPath path;
  AddAt(path, 0, 1);
  EXPECT_EQ(AddAt(path, 0, 2).motion.source, kStanding);
  const CameraPath::Place away = AddAt(path, 0.04, 3);
  EXPECT_EQ(away.motion.source, kEstimated);
  AddAt(path, 0.04, 4);
  const CameraPath::Place stands = AddAt(path, 0.04, 5);
  EXPECT_EQ(stands.motion.source, kStanding);
  EXPECT_TRUE(stands.motion.last_from_this.isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  EXPECT_NEAR(stands.world_from_camera.translation().x(), 0.04, 0.004);
}

// To where the key frame was taken: what was missed on the way is made up for.
TEST(CameraPath, ComesBackToItsKeyFrameExactly) {
  CameraPath path;
  AddAt(path, 0, 1);
  AddAt(path, 0.04, 2);
  const CameraPath::Place back = AddAt(path, 0, 3);
  EXPECT_EQ(back.motion.source, kEstimated);
  EXPECT_NEAR(back.motion.last_from_this.translation().x(), -0.04, 0.004);
  EXPECT_TRUE(back.world_from_camera.isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  EXPECT_EQ(AddAt(path, 0, 4).motion.source, kStanding);
}

// Most of what is seen is carried along, by as much again.
TEST(CameraPath, TakesTheMotionFromWhatIsNoObject) {
  const cv::Rect carried(40, 0, 240, 240);
  CameraPath path;
  for (const double x_m : {0.0, 0.04}) {
    View view(x_m, 1);
    View(2 * x_m, 2).frame.color_rgb(carried).copyTo(view.frame.color_rgb(carried));
    view.detections.labels(carried).setTo(1);
    const CameraPath::Place place = path.Add(view.frame, view.detections.labels, {});
    if (x_m == 0) continue;
    EXPECT_EQ(place.motion.source, kEstimated);
    EXPECT_NEAR(place.motion.last_from_this.translation().x(), x_m, 0.004);
  }
}

TEST(CameraPath, TakesTheMotionFromObjectsWhereThereIsNothingElse) {
  CameraPath path;
  for (const double x_m : {0.0, 0.04}) {
    View view(x_m, 1);
    view.detections.labels.setTo(1);
    const CameraPath::Place place = path.Add(view.frame, view.detections.labels, {});
    EXPECT_NEAR(place.motion.last_from_this.translation().x(), x_m, 0.004);
  }
}

// Depth was measured of the left half, of all and of the right half in turn.
TEST(CameraPath, FindsInTheLastFrameWhatTheKeyFrameDoesNotShow) {
  CameraPath path;
  CameraPath::Place place;
  for (int i = 0; i < 3; ++i) {
    View view(0.04 * i, 1 + i);
    if (i != 1) view.Cover({i == 0 ? 160 : 0, 0, 160, 240}, std::nanf(""));
    place = path.Add(view.frame, view.detections.labels, {});
  }
  EXPECT_EQ(place.motion.source, kEstimated);
  EXPECT_NEAR(place.world_from_camera.translation().x(), 0.08, 0.006);
}

TEST(CameraPath, SeesThatTheCameraStandsWithoutDepth) {
  CameraPath path;
  AddAt(path, 0, 1);
  AddAt(path, 0.04, 2);
  View view(0.04, 3);
  view.frame.depth_m.setTo(std::nanf(""));
  EXPECT_EQ(path.Add(view.frame, view.detections.labels, {}).motion.source, kStanding);
}

// A wall 4 m away, of which the image shows 1.28 m less on one side; the same upside down.
TEST(CameraPath, WhatIsTooFarForAFrameIsAMistake) {
  const View first(0, 1);
  View beside(0.32, 2), turned(0, 2);
  for (const View* next : {&beside, &turned}) {
    CameraPath path;
    RgbdFrame from = first.frame, to = next->frame;
    from.depth_m = to.depth_m = cv::Mat(testing::kSize, CV_32FC1, cv::Scalar(4));
    if (next == &turned) cv::rotate(to.color_rgb, to.color_rgb, cv::ROTATE_180);
    path.Add(from, first.detections.labels, {});
    const CameraMotion motion = path.Add(to, first.detections.labels, {}).motion;
    EXPECT_EQ(motion.source, kUnknown);
    EXPECT_TRUE(motion.last_from_this.isApprox(Eigen::Isometry3d::Identity()));
  }
}

TEST(CameraPath, TakesTheMotionFromFramesOfWhichOneHasAPose) {
  CameraPath path;
  AddAt(path, 0, 1);
  AddAt(path, 0.04, 2);
  for (int i = 2; i < 6; ++i) {
    const auto pose = i % 2 == 0 ? std::optional(PoseAt(5 * i)) : std::nullopt;
    const CameraPath::Place place = AddAt(path, 0.04 * i, i + 1, pose);
    EXPECT_EQ(place.motion.source, kEstimated) << "frame " << i;
    EXPECT_NEAR(place.motion.last_from_this.translation().x(), 0.04, 0.004) << "frame " << i;
  }
}

// The wheels slipped: the image is the one of before, but where poses were given they hold.
TEST(CameraPath, DoesNotGoBackToFramesBeforePoses) {
  CameraPath path;
  AddAt(path, 0, 1);
  AddAt(path, 0.04, 2);
  AddAt(path, 0.04, 3, PoseAt(5));
  AddAt(path, 0.04, 4, PoseAt(5.25));
  const CameraPath::Place place = AddAt(path, 0.04, 5);
  EXPECT_EQ(place.motion.source, kUnknown);
  EXPECT_NEAR(place.world_from_camera.translation().x(), 0.29 + 0.25, 0.004) << "it goes on";
}

TEST(CameraPath, SaysWhenNothingTells) {
  CameraPath path;
  View blank;
  blank.frame.color_rgb.setTo(cv::Scalar::all(128));
  path.Add(blank.frame, blank.detections.labels, {});
  const auto place = path.Add(blank.frame, blank.detections.labels, {});
  EXPECT_EQ(place.motion.source, kUnknown);
  EXPECT_TRUE(place.motion.last_from_this.isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_EQ(AddAt(path, 0, 1).motion.source, kUnknown);
}

TEST(CameraPath, NonsensePosesAreNotBelieved) {
  CameraPath path;
  AddAt(path, 0, 1, PoseAt(0));
  EXPECT_EQ(AddAt(path, 0, 2, PoseAt(1e5)).motion.source, kUnknown) << "a map that was found";
  EXPECT_EQ(AddAt(path, 0, 3, PoseAt(1e5 + 0.25)).motion.source, kGiven);
  Eigen::Isometry3d torn = PoseAt(1e5 + 0.5);
  torn.linear()(1, 1) = std::nan("");
  EXPECT_TRUE(AddAt(path, 0, 3, torn).world_from_camera.matrix().allFinite());
  const auto lost = AddAt(path, 0, 4, PoseAt(1e300));
  EXPECT_TRUE(lost.world_from_camera.matrix().allFinite());
  EXPECT_LT(lost.world_from_camera.translation().norm(), 1);
  EXPECT_EQ(AddAt(path, 0, 5, PoseAt(3)).motion.source, kStanding) << "no pose before this one";
}

}  // namespace
}  // namespace fovea
