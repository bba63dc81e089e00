// A square 1 m away before a wall 2 m away.
#include "core/grasping/hidden_border.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace fovea {
namespace {

struct Square {
  cv::Mat points = cv::Mat(60, 60, CV_32FC3, cv::Scalar(0, 0, 2));
  cv::Mat labels = cv::Mat::zeros(60, 60, CV_16UC1);
  CameraIntrinsics intrinsics = {50, 50, 29.5, 29.5};
  DetectedObject object;

  explicit Square(const cv::Rect& at) {
    points(at).setTo(cv::Scalar(0, 0, 1));
    labels(at).setTo(1);
    object.label = 1;
    object.bounds_px = at;
  }
  float Hidden() const {
    return HiddenShareOfBorder({points, labels, intrinsics, -Eigen::Vector3f::UnitY()}, object);
  }
};

TEST(HiddenShareOfBorder, IsNoneBeforeWhatIsFartherAway) {
  EXPECT_EQ(Square({20, 20, 20, 20}).Hidden(), 0);
}

TEST(HiddenShareOfBorder, IsTheSideAtWhichSomethingNearerStands) {
  Square square({20, 20, 20, 20});
  square.points(cv::Rect(40, 0, 20, 60)).setTo(cv::Scalar(0, 0, 0.8));
  EXPECT_FLOAT_EQ(square.Hidden(), 0.25F);
}

TEST(HiddenShareOfBorder, IsTheSideAtWhichTheImageEnds) {
  EXPECT_FLOAT_EQ(Square({0, 20, 20, 20}).Hidden(), 0.25F);
}

}  // namespace
}  // namespace fovea
