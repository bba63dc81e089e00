#include "core/paper/superpixel_contrast.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

#include "core/saliency/depth_saliency.h"

namespace fovea::paper {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

cv::Mat BoxOnAPlane(cv::Rect box) {
  cv::Mat depth(60, 80, CV_32F, cv::Scalar(2));
  depth(box) = 1.0F;
  return depth;
}

TEST(ContrastOfSuperpixels, TellsABoxFromThePlane) {
  const cv::Rect box(30, 20, 20, 20);
  const cv::Mat saliency =
      DepthSaliency(BoxOnAPlane(box), {.depth_prior = false}, ContrastOfSuperpixels(1));
  EXPECT_GT(cv::mean(saliency(box))[0], 0.8);
  cv::Mat plane = cv::Mat::ones(saliency.size(), CV_8U);
  plane(cv::Rect(20, 10, 40, 40)) = 0;
  EXPECT_LT(cv::mean(saliency, plane)[0], 0.02);
}

TEST(ContrastOfSuperpixels, IsThatOfPixelsWhereThereAreNone) {
  const cv::Mat depth = BoxOnAPlane({30, 20, 20, 20});
  for (const double per_diagonal : {0.0, 0.001}) {
    const cv::Mat saliency = DepthSaliency(depth, {}, ContrastOfSuperpixels(per_diagonal));
    EXPECT_EQ(cv::norm(saliency, DepthSaliency(depth), cv::NORM_INF), 0) << per_diagonal;
  }
  EXPECT_GT(cv::norm(DepthSaliency(depth, {}, ContrastOfSuperpixels(1)), DepthSaliency(depth),
                     cv::NORM_INF),
            0);
}

TEST(ContrastOfSuperpixels, IsZeroOnConstantDepth) {
  const cv::Mat depth(30, 40, CV_32F, cv::Scalar(1.3));
  EXPECT_EQ(cv::countNonZero(DepthSaliency(depth, {}, ContrastOfSuperpixels(1))), 0);
}

TEST(ContrastOfSuperpixels, IsZeroWhereThereIsNoDepth) {
  const cv::Mat none(30, 40, CV_32F, cv::Scalar(kNaN));
  EXPECT_EQ(cv::countNonZero(DepthSaliency(none, {}, ContrastOfSuperpixels(1))), 0);

  cv::Mat depth = BoxOnAPlane({30, 20, 20, 20});
  depth(cv::Rect(0, 0, 80, 15)) = kNaN;
  depth(cv::Rect(35, 25, 4, 4)) = kNaN;
  const cv::Mat saliency = DepthSaliency(depth, {}, ContrastOfSuperpixels(1));
  EXPECT_TRUE(cv::checkRange(saliency, true, nullptr, 0.0, 1.0 + 1e-6));
  EXPECT_EQ(cv::countNonZero(saliency(cv::Rect(0, 0, 80, 15))), 0);
  EXPECT_EQ(cv::countNonZero(saliency(cv::Rect(35, 25, 4, 4))), 0);
}

}  // namespace
}  // namespace fovea::paper
