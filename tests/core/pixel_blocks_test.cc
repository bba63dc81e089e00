#include "core/pixel_blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>

#include "core/detector.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

RgbdFrame FrameOf(const cv::Mat& depth_m, double focal_px) {
  return {cv::Mat(depth_m.size(), CV_8UC3, cv::Scalar(9, 9, 9)),
          depth_m,
          {focal_px, focal_px, depth_m.cols / 2.0, depth_m.rows / 2.0},
          {}};
}

int EdgePx(const cv::Size& size, double focal_px, double voxel_m = 0.01) {
  const RgbdFrame frame = FrameOf(cv::Mat(size, CV_32FC1, cv::Scalar(1.0F)), focal_px);
  return BlocksOf(frame, {.size_m = voxel_m, .perspective = true}).edge_px;
}

TEST(PixelBlocks, LeaveSomeToTheEdgeOfAVoxel) {
  EXPECT_EQ(EdgePx({640, 480}, 525), 2);
  EXPECT_EQ(EdgePx({320, 240}, 262), 1);
  EXPECT_EQ(EdgePx({1280, 720}, 920), 3);
  EXPECT_EQ(EdgePx({640, 480}, 525, 0.005), 1);  // finer voxels need finer blocks
}

TEST(PixelBlocks, AreNeitherSmallerThanAPixelNorLargerThanTheImage) {
  EXPECT_EQ(EdgePx({16, 16}, 1), 1);
  EXPECT_EQ(EdgePx({640, 7}, 1e6, 0.1), 7);
  EXPECT_EQ(EdgePx({1, 1}, 500), 1);
}

TEST(PixelBlocks, ShowWhatIsInFrontAlongTheSameRays) {
  const cv::Mat depth_m = (cv::Mat_<float>(2, 4) << 1, 2, kNone, kNone, 2, 2, kNone, kNone);
  RgbdFrame frame = FrameOf(depth_m, 525);
  frame.color_rgb.at<cv::Vec3b>(0, 0) = {49, 9, 9};
  frame.unseen = (cv::Mat_<std::uint8_t>(2, 4) << 1, 0, 1, 1, 1, 1, 1, 1);
  const RgbdFrame coarse = InBlocks(frame, depth_m, {2, depth_m.size()});
  ASSERT_EQ(coarse.depth_m.size(), cv::Size(2, 1));
  EXPECT_EQ(coarse.depth_m.at<float>(0), 1);
  EXPECT_TRUE(std::isnan(coarse.depth_m.at<float>(1)));
  EXPECT_EQ(coarse.color_rgb.at<cv::Vec3b>(0), cv::Vec3b(19, 9, 9));
  EXPECT_EQ(coarse.unseen.at<std::uint8_t>(0), 0);
  EXPECT_NE(coarse.unseen.at<std::uint8_t>(1), 0);
  // The middle of the second block lies between its pixels.
  const Eigen::Vector3f mean =
      (RayOf({2, 0}, frame.intrinsics) + RayOf({3, 1}, frame.intrinsics)) / 2;
  EXPECT_TRUE(RayOf({1, 0}, coarse.intrinsics).isApprox(mean, 1e-5F));
}

TEST(PixelBlocks, GiveTheirPixelsBack) {
  const PixelBlocks blocks{3, {7, 5}};
  EXPECT_EQ(blocks.InPixels(cv::Point(1, 0)), cv::Point(4, 1));
  EXPECT_EQ(blocks.InPixels(cv::Point(2, 1)), cv::Point(6, 4));  // cut by the border
  EXPECT_EQ(blocks.InPixels(cv::Rect(1, 1, 2, 1)), cv::Rect(3, 3, 4, 2));
  const cv::Mat of_blocks = (cv::Mat_<float>(2, 3) << 1, 2, 3, 4, 5, 6);
  const cv::Mat of_pixels = blocks.InPixels(of_blocks);
  ASSERT_EQ(of_pixels.size(), blocks.image);
  EXPECT_EQ(of_pixels.at<float>(2, 2), 1);
  EXPECT_EQ(of_pixels.at<float>(4, 6), 6);
}

TEST(FillFromBlocks, LeavesWhatPixelsHave) {
  // As wide as the widest registers and wider: OpenCV compares NaN there in a way of its own.
  constexpr int kCols = 70;
  cv::Mat depth_m(1, kCols, CV_32FC1, cv::Scalar(kNone));
  cv::Mat of_blocks(1, kCols / 2, CV_32FC1, cv::Scalar(2.0F));
  depth_m.at<float>(0) = 1;
  of_blocks.at<float>(1) = kNone;
  const cv::Mat filled =
      FillFromBlocks(depth_m, of_blocks, of_blocks == of_blocks, {2, depth_m.size()});
  EXPECT_EQ(filled.at<float>(0), 1);
  EXPECT_EQ(filled.at<float>(1), 2);
  EXPECT_TRUE(std::isnan(filled.at<float>(2)));
  for (int col = 4; col < kCols; ++col) EXPECT_EQ(filled.at<float>(col), 2) << col;
  EXPECT_TRUE(std::isnan(depth_m.at<float>(1)));  // is not changed
}

TEST(FillFromBlocks, FillsTheseBlocksAlone) {
  const cv::Mat depth_m(2, 4, CV_32FC1, cv::Scalar(kNone));
  const cv::Mat of_blocks = (cv::Mat_<float>(1, 2) << 1, 2);
  const cv::Mat which = (cv::Mat_<std::uint8_t>(1, 2) << 0, 255);
  const cv::Mat filled = FillFromBlocks(depth_m, of_blocks, which, {2, depth_m.size()});
  EXPECT_EQ(cv::countNonZero(filled == 2), 4);
  EXPECT_TRUE(std::isnan(filled.at<float>(1, 1)));
}

TEST(FillFromBlocks, CopiesNothingWhereNothingIsToBeFilled) {
  const cv::Mat depth_m = (cv::Mat_<float>(1, 4) << 1, 3, kNone, kNone);
  const cv::Mat none = cv::Mat::zeros(1, 2, CV_8UC1);
  EXPECT_EQ(FillFromBlocks(depth_m, cv::Mat::ones(1, 2, CV_32FC1), none, {2, depth_m.size()}).data,
            depth_m.data);
}

TEST(LabelsOfPixels, FollowTheSurfaceThatAPixelShows) {
  // A thing at 1 m, whose last block also shows the wall behind it at 2 m.
  const cv::Mat depth_m = (cv::Mat_<float>(1, 6) << 1, 1, 1, 2, 2, 1.5F);
  const cv::Mat wall_beside = (cv::Mat_<float>(1, 3) << 1, 1, 2);
  const cv::Mat nothing_beside = (cv::Mat_<float>(1, 3) << 1, 1, 1.5F);
  const cv::Mat of_blocks = (cv::Mat_<std::uint16_t>(1, 3) << 7, 8, 4);
  const PixelBlocks blocks{2, depth_m.size()};
  const cv::Mat expected = (cv::Mat_<std::uint16_t>(1, 6) << 7, 7, 8, 4, 4, 0);
  const cv::Mat labels = LabelsOfPixels(of_blocks, wall_beside, depth_m, 10, blocks);
  EXPECT_EQ(cv::norm(labels, expected, cv::NORM_INF), 0);
  const cv::Mat cut = LabelsOfPixels(of_blocks, nothing_beside, depth_m, 10, blocks);
  EXPECT_EQ(cut.at<std::uint16_t>(3), 0);
}

TEST(LabelsOfPixels, AreThoseOfThingsBesideTheBlockToo) {
  const cv::Mat depth_m = (cv::Mat_<float>(1, 4) << 1, 1, 1, 2);
  const cv::Mat of_depth = (cv::Mat_<float>(1, 2) << 1, 1.5F);
  const cv::Mat of_blocks = (cv::Mat_<std::uint16_t>(1, 2) << 3, 0);
  const cv::Mat labels = LabelsOfPixels(of_blocks, of_depth, depth_m, 10, {2, depth_m.size()});
  EXPECT_EQ(labels.at<std::uint16_t>(2), 3);
  EXPECT_EQ(labels.at<std::uint16_t>(3), 0);
}

TEST(LabelsOfPixels, WithoutDepthInReachAreNone) {
  const cv::Mat depth_m = (cv::Mat_<float>(2, 2) << 1, kNone, 3, 1);
  const cv::Mat of_depth(1, 1, CV_32FC1, cv::Scalar(1.0F));
  const cv::Mat of_block(1, 1, CV_16UC1, cv::Scalar(3));
  const cv::Mat labels = LabelsOfPixels(of_block, of_depth, depth_m, 2, {2, depth_m.size()});
  EXPECT_EQ(cv::countNonZero(labels == 3), 2);
}

// Blocks have the least depth in them: by them the table would be 1 mm higher.
TEST(PixelBlocks, LeaveThePlaneOfTheTableToPixels) {
  const CameraIntrinsics camera{525, 525, 319.5, 239.5};
  const Eigen::Vector3f up = -Eigen::Vector3f(0, 1, 1).normalized();
  const float offset_m = 0.7F;  // 0.99 m along the axis
  RgbdFrame frame{
      cv::Mat(480, 640, CV_8UC3, cv::Scalar(90, 90, 90)), cv::Mat(480, 640, CV_32FC1), camera, {}};
  for (int row = 0; row < 480; ++row) {
    for (int col = 0; col < 640; ++col) {
      frame.depth_m.at<float>(row, col) = -offset_m / up.dot(RayOf({col, row}, camera));
    }
  }
  const Detections found = Detect(frame, OptionsOfProfile("default"));
  ASSERT_TRUE(found.support.has_value());
  for (const cv::Point pixel : {cv::Point(0, 0), {639, 0}, {320, 240}, {0, 479}, {639, 479}}) {
    const Eigen::Vector3f on_table = frame.depth_m.at<float>(pixel) * RayOf(pixel, camera);
    EXPECT_NEAR(found.support->HeightOf(on_table), 0, 1e-4F) << pixel;
  }
}

}  // namespace
}  // namespace fovea
