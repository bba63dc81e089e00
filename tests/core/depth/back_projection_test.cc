#include "core/depth/back_projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/depth/measured_depth.h"

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

TEST(DepthUpTo, LeavesOutWhatIsFarther) {
  const cv::Mat depth = (cv::Mat_<float>(1, 3) << 1, 2, 2.1);
  const cv::Mat near = DepthUpTo(depth, 2);
  EXPECT_EQ(near.at<float>(0), 1);
  EXPECT_EQ(near.at<float>(1), 2);
  EXPECT_TRUE(std::isnan(near.at<float>(2)));
}

TEST(PixelPoints, AreThoseOfTheImage) {
  const CameraIntrinsics intrinsics{.fx_px = 525, .fy_px = 520, .cx_px = 2.5, .cy_px = 1.5};
  cv::Mat depth(4, 6, CV_32FC1);
  for (int i = 0; i < 24; ++i) depth.at<float>(i / 6, i % 6) = 0.7F + 0.1F * static_cast<float>(i);
  const cv::Mat image = BackProject(depth, intrinsics, 10);
  const PixelPoints points(depth, intrinsics);
  for (int row = 0; row < 4; ++row) {
    for (int col = 0; col < 6; ++col) {
      const cv::Vec3f& point = image.at<cv::Vec3f>(row, col);
      EXPECT_EQ(points.At(row, col), Eigen::Vector3f(point[0], point[1], point[2]));
    }
  }
  depth.at<float>(1, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(points.At(1, 1).array().isNaN().all());
}

}  // namespace
}  // namespace fovea
