#include "core/depth/back_projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fovea {
namespace {

TEST(BackProject, FollowsThePinholeModel) {
  const CameraIntrinsics intrinsics{.fx_px = 500, .fy_px = 400, .cx_px = 1, .cy_px = 2};
  cv::Mat depth(4, 6, CV_32FC1, cv::Scalar(2.0F));
  const cv::Mat points = BackProject(depth, intrinsics, 10);
  const cv::Vec3f& point = points.at<cv::Vec3f>(3, 5);
  EXPECT_FLOAT_EQ(point[0], 2.0F * (5 - 1) / 500);
  EXPECT_FLOAT_EQ(point[1], 2.0F * (3 - 2) / 400);
  EXPECT_FLOAT_EQ(point[2], 2.0F);
}

TEST(BackProject, LeavesOutMissingAndFarDepth) {
  cv::Mat depth = (cv::Mat_<float>(1, 3) << std::numeric_limits<float>::quiet_NaN(), 4.0F, 4.1F);
  const cv::Mat points = BackProject(depth, {1, 1, 0, 0}, 4.0);
  EXPECT_TRUE(std::isnan(points.at<cv::Vec3f>(0)[0]));
  EXPECT_FALSE(std::isnan(points.at<cv::Vec3f>(1)[0]));
  for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(std::isnan(points.at<cv::Vec3f>(2)[axis]));
}

}  // namespace
}  // namespace fovea
