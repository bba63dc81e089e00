#include "core/tracking/camera_motion.h"

#include <gtest/gtest.h>

#include "tests/core/tracking/table_view.h"

namespace fovea {
namespace {

using testing::View;
using enum CameraMotionSource;

CameraPath::Place AddAt(CameraPath& path, double x_m, std::uint64_t seed,
                        const std::optional<Eigen::Isometry3d>& pose = {}) {
  const View view(x_m, seed);
  return path.Add(view.frame, view.detections.labels, pose);
}

Eigen::Isometry3d PoseAt(double x_m) { return Eigen::Isometry3d(Eigen::Translation3d(x_m, 0, 0)); }

TEST(IsSameView, KnowsNoiseAndExposureFromMotion) {
  const auto small = [](double x_m, std::uint64_t seed, double gain = 1) {
    View view(x_m, seed);
    view.frame.color_rgb *= gain;
    return SmallViewOf(view.frame, view.detections.labels);
  };
  EXPECT_TRUE(IsSameView(small(0, 1), small(0, 2)));
  EXPECT_TRUE(IsSameView(small(0, 1), small(0, 2, 0.95)));
  EXPECT_FALSE(IsSameView(small(0, 1), small(1 / 250.0, 2))) << "one pixel";
  EXPECT_FALSE(IsSameView(small(0, 1), small(0.3, 2)));
  View blank;
  blank.frame.color_rgb.setTo(cv::Scalar::all(128));
  const SmallView nothing = SmallViewOf(blank.frame, blank.detections.labels);
  EXPECT_FALSE(IsSameView(nothing, nothing)) << "that cannot be told without contrast";
}

// 160 pixels wide at the image's own proportions it would have millions of rows.
TEST(SmallView, IsSmallHoweverNarrowTheImage) {
  RgbdFrame ribbon;
  ribbon.color_rgb = cv::Mat(2000, 1, CV_8UC3, cv::Scalar::all(90));
  const SmallView view = SmallViewOf(ribbon, cv::Mat::zeros(2000, 1, CV_16UC1));
  EXPECT_LE(view.gray.rows, 640);
  EXPECT_EQ(view.movable.size(), view.gray.size());
}

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
  const auto lost = AddAt(path, 0, 4, PoseAt(1e300));
  EXPECT_TRUE(lost.world_from_camera.matrix().allFinite());
  EXPECT_LT(lost.world_from_camera.translation().norm(), 1);
  EXPECT_EQ(AddAt(path, 0, 5, PoseAt(3)).motion.source, kStanding) << "no pose before this one";
}

}  // namespace
}  // namespace fovea
