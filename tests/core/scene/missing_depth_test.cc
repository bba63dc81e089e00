#include "core/scene/missing_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

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
        const Eigen::Vector3d ray((col - 80) / intrinsics_.fx_px, (row - 60) / intrinsics_.fy_px,
                                  1);
        depth_m_.at<float>(row, col) = static_cast<float>(-0.5 / up.dot(ray));
      }
    }
  }

  cv::Mat StandIn(double max_height_m = 0.5) {
    points_ = BackProject(depth_m_, intrinsics_, kMaxDepth_m);
    normals_ = {cv::Mat(60, 80, CV_32FC3, cv::Scalar::all(kNone)), 2};
    std::vector<Support> supports = others_;
    supports.insert(supports.begin(), support_);
    return StandInForMissing(depth_m_, supports, intrinsics_, {max_height_m, kMaxDepth_m}, points_,
                             normals_);
  }

  float HeightAt(int row, int col) const {
    const cv::Vec3f& p = points_.at<cv::Vec3f>(row, col);
    return support_.surface.HeightOf({p[0], p[1], p[2]});
  }

  void ExpectNothing() { EXPECT_EQ(cv::countNonZero(StandIn()), 0); }

  static constexpr double kMaxDepth_m = 10;
  CameraIntrinsics intrinsics_{140, 140, 80, 60};
  cv::Mat depth_m_ = cv::Mat(120, 160, CV_32FC1);
  Support support_;
  std::vector<Support> others_;
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

  EXPECT_NEAR(HeightAt(hole.br().y - 1, 78), 0, 0.005);  // of a corner, which is farther
  const Eigen::Vector3f up = support_.surface.normal;
  const cv::Vec3f normal = normals_.vectors.at<cv::Vec3f>(25, 39);
  EXPECT_NEAR(Eigen::Vector3f(normal[0], normal[1], normal[2]).dot(up), 0, 1e-5);
  // All of it in one upright plane.
  const cv::Vec3f top = points_.at<cv::Vec3f>(42, 78);
  const cv::Vec3f bottom = points_.at<cv::Vec3f>(60, 72);
  EXPECT_NEAR((top - bottom).dot(normal), 0, 1e-5);
  EXPECT_GT(HeightAt(42, 78), 0.1);
}

TEST_F(MissingDepth, LeavesTheShadowOfWhatIsNearer) {
  LookDown(40);
  depth_m_(cv::Rect(86, 30, 30, 40)).setTo(0.35F);  // of a box that stands there
  depth_m_(cv::Rect(70, 30, 16, 40)).setTo(kNone);
  ExpectNothing();
  depth_m_(cv::Rect(86, 30, 30, 40)).setTo(0.6F);  // hides less
  EXPECT_GT(cv::countNonZero(StandIn()), 0);
}

// At 1 and 0.4 m: 140 px · 0.08 m · (1 / 0.4 - 1) are 16.8 pixels, and one is lost at an edge.
TEST_F(MissingDepth, AHoleIsLongerThanTheShadowAndAnEdge) {
  for (const int width_px : {17, 18}) {
    LookDown(40);
    depth_m_(cv::Rect(50, 30, 20, 40)).setTo(1.0F);
    depth_m_(cv::Rect(70, 30, 50, 40)).setTo(0.4F);
    depth_m_(cv::Rect(70, 30, width_px, 40)).setTo(kNone);
    EXPECT_EQ(cv::countNonZero(StandIn()) > 0, width_px == 18);
  }
}

// Its foot is 0.76 m away, what is behind it 3 m: 140 px · 0.05 m · (1 / 0.76 - 1 / 3) are 7
// pixels.
TEST_F(MissingDepth, LeavesTheShadowOfWhatStandsThere) {
  LookDown(40);
  depth_m_(cv::Rect(50, 30, 20, 40)).setTo(3.0F);
  depth_m_(cv::Rect(70, 40, 16, 24)).setTo(kNone);
  const cv::Mat standing = StandIn();
  EXPECT_EQ(cv::countNonZero(standing.colRange(0, 77)), 0);
  EXPECT_GT(cv::countNonZero(standing.col(77)), 20);
}

TEST_F(MissingDepth, StandsNoHigherThanObjectsDo) {
  LookDown(40);
  depth_m_(cv::Rect(70, 40, 16, 24)).setTo(kNone);
  const cv::Mat standing = StandIn(0.05);
  float highest_m = 0;
  for (int row = 40; row < 64; ++row) {
    if (standing.at<std::uint8_t>(row, 78) != 0) highest_m = std::max(highest_m, HeightAt(row, 78));
  }
  EXPECT_NEAR(highest_m, 0.045, 0.005);
}

TEST_F(MissingDepth, StandsOnTheNearestSupportBelowTheCamera) {
  LookDown(40);
  depth_m_(cv::Rect(70, 40, 16, 24)).setTo(kNone);
  const int on_table = cv::countNonZero(StandIn());
  const Eigen::Vector3f& up = support_.surface.normal;
  others_ = {{{up, 1.0F, 1000}, {}},
             {{up, -0.3F, 1000}, {}}};  // the floor, a shelf over the camera
  EXPECT_EQ(cv::countNonZero(StandIn()), on_table);
  EXPECT_NEAR(HeightAt(63, 78), 0, 0.005);
}

TEST_F(MissingDepth, NothingStandsBelowAShelf) {
  LookDown(10);
  support_.surface.offset_m = -0.3F;
  depth_m_.setTo(1.5F);
  depth_m_(cv::Rect(70, 5, 16, 24)).setTo(kNone);
  ExpectNothing();
}

TEST_F(MissingDepth, LeavesThePointsOfOthersAsTheyAre) {
  LookDown(40);
  depth_m_(cv::Rect(70, 40, 16, 24)).setTo(kNone);
  const cv::Mat points = BackProject(depth_m_, intrinsics_, kMaxDepth_m);
  cv::Mat own = points;
  normals_ = {cv::Mat(60, 80, CV_32FC3, cv::Scalar::all(kNone)), 2};
  StandInForMissing(depth_m_, {support_}, intrinsics_, {0.5, kMaxDepth_m}, own, normals_);
  EXPECT_TRUE(std::isnan(points.at<cv::Vec3f>(50, 78)[2]));
  EXPECT_FALSE(std::isnan(own.at<cv::Vec3f>(50, 78)[2]));
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

// Registered depth leaves some columns free.
TEST_F(MissingDepth, LeavesWhatIsAtAMargin) {
  LookDown(40);
  depth_m_(cv::Rect(0, 0, 8, 120)).setTo(kNone);
  depth_m_(cv::Rect(8, 40, 16, 24)).setTo(kNone);
  depth_m_(cv::Rect(152, 0, 8, 120)).setTo(kNone);
  depth_m_(cv::Rect(136, 40, 16, 24)).setTo(kNone);
  ExpectNothing();
}

TEST_F(MissingDepth, LeavesWhatIsBesideTheFootprint) {
  LookDown(40);
  depth_m_(cv::Rect(70, 40, 16, 24)).setTo(kNone);
  const std::vector<Eigen::Vector3f> far_aside(100, {3, 0, 1});
  support_.footprint = Footprint(far_aside, {}, support_.surface, 0, 0);
  ExpectNothing();
}

// Along row 60 a line of sight meets the table so far away that no int counts the cells of its
// footprint until there.
TEST_F(MissingDepth, LeavesWhatIsOnTheHorizon) {
  LookDown(0);
  support_.surface.normal = {0, -1, -1e-9F};
  depth_m_.setTo(3.0F);
  depth_m_(cv::Rect(40, 50, 60, 20)).setTo(kNone);
  const std::vector<Eigen::Vector3f> near_by(100, {0, 0.5F, 1});
  support_.footprint = Footprint(near_by, {}, support_.surface, 0, 0.1);
  ExpectNothing();
}

// The stand-in faces what is nearest, at the lower left, and goes on to the right without end.
TEST_F(MissingDepth, StandsNoFartherThanDepthCounts) {
  intrinsics_.fx_px = intrinsics_.fy_px = 40;
  LookDown(20);
  depth_m_(cv::Rect(8, 48, 140, 10)).setTo(kNone);
  depth_m_(cv::Rect(8, 48, 16, 62)).setTo(kNone);
  const cv::Mat standing = StandIn();
  float farthest_m = 0;
  for (int row = 0; row < standing.rows; ++row) {
    for (int col = 0; col < standing.cols; ++col) {
      if (standing.at<std::uint8_t>(row, col) == 0) continue;
      farthest_m = std::max(farthest_m, points_.at<cv::Vec3f>(row, col)[2]);
    }
  }
  EXPECT_GT(farthest_m, 1);
  EXPECT_LE(farthest_m, kMaxDepth_m);
}

TEST_F(MissingDepth, LeavesWhatIsLookedDownInto) {
  LookDown(80);
  depth_m_(cv::Rect(70, 50, 16, 24)).setTo(kNone);
  ExpectNothing();
}

}  // namespace
}  // namespace fovea
