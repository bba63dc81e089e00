#include "core/shape/seen_through.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

constexpr int kLabel = 3;

// A camera one metre above the floor, which sees it everywhere; a box of 20 cm and 5 cm high stands
// in the middle, of which `label` says what the mask covers.
class SeenThrough : public ::testing::Test {
 protected:
  SeenThrough()
      : points_(200, 200, CV_32FC3, cv::Scalar(0, 0, 1)),
        labels_(200, 200, CV_16UC1, cv::Scalar(0)) {
    frame_.rotation << 1, 0, 0, 0, -1, 0, 0, 0, -1;
    frame_.origin = {0, 0, 1};
    solid_.half_length_m = solid_.half_width_m = 0.1F;
    solid_.height_m = 0.05F;
  }

  float Share() const {
    return SeenThroughShare({points_, labels_, intrinsics_}, kLabel, {78, 78, 44, 44}, solid_,
                            frame_);
  }

  cv::Mat points_, labels_;
  const CameraIntrinsics intrinsics_{200, 200, 99.5, 99.5};
  LevelFrame frame_;
  Solid solid_;
};

TEST_F(SeenThrough, IsNothingWhereTheMaskIs) {
  labels_(cv::Rect(78, 78, 44, 44)) = kLabel;
  EXPECT_EQ(Share(), 0);
}

TEST_F(SeenThrough, IsNothingAtTheEdgeOfTheMask) {
  labels_(cv::Rect(81, 81, 38, 38)) = kLabel;
  EXPECT_EQ(Share(), 0);
}

TEST_F(SeenThrough, IsWhatTheMaskLeavesOut) {
  labels_(cv::Rect(100, 78, 22, 44)) = kLabel;
  EXPECT_NEAR(Share(), 3.0 / 8, 0.01);  // columns of samples: one of the four is at the edge
}

TEST_F(SeenThrough, IsNotWhatIsHiddenOrHasNoDepth) {
  labels_(cv::Rect(100, 78, 22, 44)) = kLabel;
  points_.setTo(cv::Scalar(0, 0, 0.7));
  EXPECT_EQ(Share(), 0);
  points_.setTo(cv::Scalar::all(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(Share(), 0);
}

TEST_F(SeenThrough, IsNotWhatNoiseMayBe) {
  labels_(cv::Rect(100, 78, 22, 44)) = kLabel;
  solid_.height_m = 0.008F;
  EXPECT_EQ(Share(), 0);
}

TEST_F(SeenThrough, IsWholeWhereItIsSeenThroughAllOver) { EXPECT_EQ(Share(), 1); }

TEST_F(SeenThrough, IsNotWhatTheMaskSurrounds) {
  labels_(cv::Rect(78, 78, 44, 44)) = kLabel;
  labels_(cv::Rect(86, 86, 28, 28)) = 0;
  EXPECT_EQ(Share(), 0);
  labels_(cv::Rect(86, 114, 28, 8)) = 0;  // open on one side
  EXPECT_GT(Share(), 0.3);
}

TEST_F(SeenThrough, KnowsNothingBehindTheCameraOrBesideTheImage) {
  frame_.origin = {0, 0, -1};
  EXPECT_EQ(Share(), 0);
  frame_.origin = {5, 0, 1};
  EXPECT_EQ(Share(), 0);
}

}  // namespace
}  // namespace fovea
