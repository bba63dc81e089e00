#include "core/scene/missing_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "core/depth/back_projection.h"

namespace fovea {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// A table seen from 0.5 m above it, `pitch_deg` below the horizon.
class MissingDepth : public ::testing::Test {
 protected:
  void LookDown(double pitch_deg) {
    const double pitch = pitch_deg * std::numbers::pi / 180;
    const Eigen::Vector3d up(0, -std::cos(pitch), -std::sin(pitch));
    support_.surface = {up.cast<float>(), 0.5F, 1000};
    for (int row = 0; row < depth_m_.rows; ++row) {
      for (int col = 0; col < depth_m_.cols; ++col) {
        const Eigen::Vector3d ray((col - 80) / kFocal_px, (row - 60) / kFocal_px, 1);
        depth_m_.at<float>(row, col) = static_cast<float>(-0.5 / up.dot(ray));
      }
    }
  }

  cv::Mat StandIn() {
    points_ = BackProject(depth_m_, intrinsics_, 10);
    normals_ = {cv::Mat(60, 80, CV_32FC3, cv::Scalar::all(kNone)), 2};
    return StandInForMissing(depth_m_, {support_}, intrinsics_, 0.5, points_, normals_);
  }

  void ExpectNothing() { EXPECT_EQ(cv::countNonZero(StandIn()), 0); }

  static constexpr double kFocal_px = 140;
  const CameraIntrinsics intrinsics_{kFocal_px, kFocal_px, 80, 60};
  cv::Mat depth_m_ = cv::Mat(120, 160, CV_32FC1);
  Support support_;
  cv::Mat points_;
  NormalMap normals_;
};

TEST_F(MissingDepth, StandsUprightWhereTheHoleEndsBelow) {
  LookDown(40);
  const cv::Rect hole(70, 40, 16, 24);
  depth_m_(hole).setTo(kNone);
  const cv::Mat standing = StandIn();
  // A disk does not reach into corners, and at the left there is its shadow on the table behind.
  EXPECT_GT(cv::countNonZero(standing), 0.9 * hole.area());
  EXPECT_GT(cv::countNonZero(standing.col(84)), cv::countNonZero(standing.col(70)));
  EXPECT_EQ(cv::countNonZero(standing), cv::countNonZero(standing(hole)));

  const auto height_at = [&](int row) {
    const cv::Vec3f& p = points_.at<cv::Vec3f>(row, 78);
    return support_.surface.HeightOf({p[0], p[1], p[2]});
  };
  EXPECT_NEAR(height_at(hole.br().y - 1), 0, 0.005);  // of a corner, which is farther
  const Eigen::Vector3f up = support_.surface.normal;
  const cv::Vec3f normal = normals_.vectors.at<cv::Vec3f>(25, 39);
  EXPECT_NEAR(Eigen::Vector3f(normal[0], normal[1], normal[2]).dot(up), 0, 1e-5);
  // All of it in one upright plane.
  const cv::Vec3f top = points_.at<cv::Vec3f>(42, 78);
  const cv::Vec3f bottom = points_.at<cv::Vec3f>(60, 72);
  EXPECT_NEAR((top - bottom).dot(normal), 0, 1e-5);
  EXPECT_GT(height_at(42), 0.1);
}

TEST_F(MissingDepth, LeavesTheShadowOfWhatIsNearer) {
  LookDown(40);
  depth_m_(cv::Rect(86, 30, 30, 40)).setTo(0.35F);  // of a box that stands there
  depth_m_(cv::Rect(70, 30, 16, 40)).setTo(kNone);
  ExpectNothing();
  depth_m_(cv::Rect(86, 30, 30, 40)).setTo(0.6F);  // hides less
  EXPECT_GT(cv::countNonZero(StandIn()), 0);
}

TEST_F(MissingDepth, LeavesWhatIsSmallOrAtTheBorderOrBesideTheSupport) {
  LookDown(40);
  depth_m_(cv::Rect(70, 40, 2, 40)).setTo(kNone);  // a seam
  depth_m_(cv::Rect(100, 40, 5, 5)).setTo(kNone);  // a speck
  depth_m_(cv::Rect(140, 40, 20, 24)).setTo(kNone);
  ExpectNothing();

  LookDown(10);  // most of the image is above the horizon
  depth_m_ = cv::min(depth_m_, 3.0F);
  depth_m_.rowRange(0, 60).setTo(3.0F);
  depth_m_(cv::Rect(70, 10, 16, 34)).setTo(kNone);
  ExpectNothing();
}

TEST_F(MissingDepth, LeavesWhatIsLookedDownInto) {
  LookDown(80);
  depth_m_(cv::Rect(70, 50, 16, 24)).setTo(kNone);
  ExpectNothing();
}

}  // namespace
}  // namespace fovea
