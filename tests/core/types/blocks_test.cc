#include "core/types/blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

TEST(Blocks, AverageColorsAndRepeatTheBorder) {
  const cv::Mat image = (cv::Mat_<uchar>(1, 3) << 10, 30, 50);
  const cv::Mat reduced = ReduceByBlocks(image, 2);
  ASSERT_EQ(reduced.size(), cv::Size(2, 1));
  EXPECT_EQ(reduced.at<uchar>(0), 20);
  EXPECT_EQ(reduced.at<uchar>(1), 50);
}

TEST(Blocks, AverageTheDepthThatIsThere) {
  const cv::Mat depth_m = (cv::Mat_<float>(3, 4) << 1, kNone, kNone, 0,  //
                           2, 3, -1, std::numeric_limits<float>::infinity(), 4, 5, 7, kNone);
  const cv::Mat reduced = ReduceDepthByBlocks(depth_m, 2);
  ASSERT_EQ(reduced.size(), cv::Size(2, 2));
  EXPECT_FLOAT_EQ(reduced.at<float>(0, 0), 2);
  EXPECT_TRUE(std::isnan(reduced.at<float>(0, 1)));
  EXPECT_FLOAT_EQ(reduced.at<float>(1, 0), 4.5F);
  EXPECT_FLOAT_EQ(reduced.at<float>(1, 1), 7);
}

TEST(Blocks, ShowTheNearestDepthThatIsThere) {
  const cv::Mat depth_m = (cv::Mat_<float>(3, 3) << 4, kNone, kNone,  //
                           3, 5, kNone, 2, kNone, 7);
  const cv::Mat reduced = NearestOfBlocks(depth_m, 2);
  ASSERT_EQ(reduced.size(), cv::Size(2, 2));
  EXPECT_FLOAT_EQ(reduced.at<float>(0, 0), 3);
  EXPECT_TRUE(std::isnan(reduced.at<float>(0, 1)));
  EXPECT_FLOAT_EQ(reduced.at<float>(1, 0), 2);
  EXPECT_FLOAT_EQ(reduced.at<float>(1, 1), 7);
}

TEST(Blocks, EnlargeToTheSizeOfTheImage) {
  const cv::Mat map = (cv::Mat_<float>(1, 2) << 1, 2);
  const cv::Mat enlarged = EnlargeBlocks(map, 2, {3, 1});
  const cv::Mat expected = (cv::Mat_<float>(1, 3) << 1, 1, 2);
  EXPECT_EQ(cv::norm(enlarged, expected, cv::NORM_INF), 0);
}

TEST(Blocks, OfOnePixelChangeNothing) {
  const cv::Mat depth_m = (cv::Mat_<float>(1, 2) << 1, 2);
  EXPECT_EQ(ReduceDepthByBlocks(depth_m, 1).data, depth_m.data);
  EXPECT_EQ(NearestOfBlocks(depth_m, 1).data, depth_m.data);
  EXPECT_EQ(ReduceByBlocks(depth_m, 1).data, depth_m.data);
  EXPECT_EQ(EnlargeBlocks(depth_m, 1, depth_m.size()).data, depth_m.data);
}

}  // namespace
}  // namespace fovea
