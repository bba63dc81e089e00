#include "core/depth/fill_depth_holes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

cv::Mat Row(std::initializer_list<float> values) {
  return cv::Mat(std::vector<float>(values), true).reshape(1, 1);
}

TEST(FillDepthHoles, GivesAHoleTheModeOfItsNeighborhood) {
  // Three values near 1 m against one at 2 m.
  const cv::Mat filled = FillDepthHoles(Row({1.000F, 1.004F, kNone, 1.002F, 2.0F}));
  EXPECT_FLOAT_EQ(filled.at<float>(2), 1.002F);
}

TEST(FillDepthHoles, TakesTheFartherOfTwoEquallyFrequentDepths) {
  const cv::Mat filled = FillDepthHoles(Row({1.0F, 1.0F, kNone, 2.0F, 2.0F}));
  EXPECT_FLOAT_EQ(filled.at<float>(2), 2.0F);
}

TEST(FillDepthHoles, LeavesMeasuredPixelsAlone) {
  const cv::Mat depth = Row({1.0F, 5.0F, 1.0F, 1.0F, 1.0F});
  const cv::Mat filled = FillDepthHoles(depth);
  EXPECT_EQ(cv::countNonZero(filled != depth), 0);
}

TEST(FillDepthHoles, ReachesTwoPixelsAPass) {
  const cv::Mat depth = Row({1.0F, kNone, kNone, kNone, kNone, kNone});
  const cv::Mat once = FillDepthHoles(depth, {.passes = 1});
  EXPECT_FLOAT_EQ(once.at<float>(2), 1.0F);
  EXPECT_TRUE(std::isnan(once.at<float>(3)));
  const cv::Mat twice = FillDepthHoles(depth, {.passes = 2});
  EXPECT_FLOAT_EQ(twice.at<float>(4), 1.0F);
  EXPECT_TRUE(std::isnan(twice.at<float>(5)));
}

TEST(FillDepthHoles, DoesNothingWithoutPassesOrDepth) {
  EXPECT_TRUE(std::isnan(FillDepthHoles(Row({1.0F, kNone}), {.passes = 0}).at<float>(1)));
  EXPECT_TRUE(std::isnan(FillDepthHoles(Row({kNone, kNone})).at<float>(0)));
}

}  // namespace
}  // namespace fovea
