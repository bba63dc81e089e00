#include "core/types/blocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

// NaN = none.
void ExpectDepths(const cv::Mat& found, const cv::Mat& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (int i = 0; i < static_cast<int>(found.total()); ++i) {
    EXPECT_THAT(found.at<float>(i / found.cols, i % found.cols),
                testing::NanSensitiveFloatEq(expected.at<float>(i / found.cols, i % found.cols)));
  }
}

TEST(Blocks, AverageTheDepthThatIsThere) {
  const cv::Mat depth_m = (cv::Mat_<float>(3, 4) << 1, kNone, kNone, 0,  //
                           2, 3, -1, std::numeric_limits<float>::infinity(), 4, 5, 7, kNone);
  ExpectDepths(ReduceDepthByBlocks(depth_m, 2), (cv::Mat_<float>(2, 2) << 2, kNone, 4.5F, 7));
}

TEST(Blocks, ShowTheNearestDepthThatIsThere) {
  const cv::Mat depth_m = (cv::Mat_<float>(3, 3) << 4, kNone, kNone,  //
                           3, 5, kNone, 2, kNone, 7);
  ExpectDepths(NearestOfBlocks(depth_m, 2), (cv::Mat_<float>(2, 2) << 3, kNone, 2, 7));
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
