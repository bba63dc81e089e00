#include "core/saliency/strength_saliency.h"

#include <gtest/gtest.h>

#include <array>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>

#include "tests/core/saliency/literal_strength.h"
#include "tests/core/saliency/strength_images.h"

namespace fovea {
namespace {

using testing::LiteralSaliency;

class SaliencyOfImage : public ::testing::TestWithParam<std::string> {};

TEST_P(SaliencyOfImage, IsTheNormalizedSumOverScalesAndChannels) {
  const auto rgb = testing::ReadColor(GetParam());
  if (!rgb) GTEST_SKIP() << MissingData(GetParam());
  cv::Mat reduced;
  cv::resize(*rgb, reduced, {81, 60}, 0, 0, cv::INTER_AREA);
  const cv::Mat saliency = StrengthSaliency(reduced);
  EXPECT_LT(cv::norm(saliency, LiteralSaliency(reduced, 4), cv::NORM_INF), 1e-7);
  EXPECT_NEAR(cv::norm(saliency), 1.0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(RealImages, SaliencyOfImage,
                         ::testing::Values("osd/learn0_color.png", "osd/learn33_color.png",
                                           "osd/test56_color.png", "floor/floor1_color.png"),
                         [](const auto& instance) {
                           const std::string& name = instance.param;
                           return name.substr(name.find('/') + 1,
                                              name.find('_') - 1 - name.find('/'));
                         });

cv::Mat ColoredPatches(cv::Size size) {
  std::mt19937 random(12);
  std::array<cv::Mat, 3> channels;
  for (cv::Mat& channel : channels) channel = testing::Plateaus(size, random);
  cv::Mat rgb;
  cv::merge(channels.data(), channels.size(), rgb);
  return rgb;
}

TEST(StrengthSaliency, TakesAsManyScalesAsAsked) {
  const cv::Mat rgb = ColoredPatches({49, 37});
  for (int num_scales : {1, 2, 4}) {
    const cv::Mat saliency = StrengthSaliency(rgb, {.num_scales = num_scales});
    EXPECT_LT(cv::norm(saliency, LiteralSaliency(rgb, num_scales), cv::NORM_INF), 1e-6);
  }
}

// Two squares inside each other, lighter by 5 and 6 in L: small steps of the channel's span, about
// half each of the image's own.
TEST(StrengthSaliency, MayTakeMaxDistOfTheImage) {
  cv::Mat rgb(60, 60, CV_8UC3, cv::Scalar::all(100));
  rgb(cv::Rect(15, 15, 30, 30)).setTo(cv::Scalar::all(105));
  rgb(cv::Rect(25, 25, 10, 10)).setTo(cv::Scalar::all(110));
  const auto outer_to_inner = [&](bool stretch) {
    const cv::Mat saliency = StrengthSaliency(rgb, {.stretch = stretch});
    return saliency.at<float>(20, 20) / saliency.at<float>(30, 30);
  };
  const auto expected = [](double span) {
    return 5 / span / (1 - (1 - 5 / span) * (1 - 6 / span));
  };
  EXPECT_NEAR(outer_to_inner(false), expected(255), 1e-3);
  EXPECT_NEAR(outer_to_inner(true), expected(11), 0.01);
}

TEST(StrengthSaliency, IsZeroOnAConstantImage) {
  const cv::Mat rgb(30, 40, CV_8UC3, cv::Scalar(10, 200, 90));
  EXPECT_EQ(cv::countNonZero(StrengthSaliency(rgb)), 0);
}

TEST(StrengthSaliency, IsZeroOnAnImageThatIsAllBorder) {
  const cv::Mat rgb = ColoredPatches({2, 1});
  const cv::Mat saliency = StrengthSaliency(rgb);
  EXPECT_EQ(saliency.size(), rgb.size());
  EXPECT_EQ(cv::countNonZero(saliency), 0);
}

TEST(StrengthSaliency, IsTheMapOfTheReducedImageInFlatBlocks) {
  const cv::Mat rgb = ColoredPatches({48, 36});
  cv::Mat reduced, enlarged;
  cv::resize(rgb, reduced, {16, 12}, 0, 0, cv::INTER_AREA);
  const cv::Mat small = LiteralSaliency(reduced, 2);
  cv::resize(small / cv::norm(small), enlarged, rgb.size(), 0, 0, cv::INTER_NEAREST);
  const cv::Mat saliency = StrengthSaliency(rgb, {.num_scales = 2, .downscale = 3});
  EXPECT_LT(cv::norm(saliency, enlarged, cv::NORM_INF), 1e-6);
}

TEST(StrengthSaliency, KeepsTheSizeWhereTheReductionDoesNotDivideIt) {
  for (const cv::Size& size : {cv::Size(47, 31), cv::Size(5, 3), cv::Size(1, 1)}) {
    const cv::Mat rgb = ColoredPatches(size);
    EXPECT_EQ(StrengthSaliency(rgb, {.downscale = 4}).size(), size);
  }
}

}  // namespace
}  // namespace fovea
