#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/saliency/strength_saliency.h"
#include "tests/core/saliency/literal_strength.h"
#include "tests/core/saliency/strength_images.h"

namespace fovea {
namespace {

using testing::LiteralStrength;

void ExpectSameBits(const cv::Mat& actual, const cv::Mat& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  ASSERT_EQ(actual.type(), CV_32FC1);
  for (int y = 0; y < expected.rows; ++y) {
    for (int x = 0; x < expected.cols; ++x) {
      const float a = actual.at<float>(y, x), b = expected.at<float>(y, x);
      ASSERT_EQ(std::bit_cast<std::uint32_t>(a), std::bit_cast<std::uint32_t>(b))
          << x << "," << y << ": " << a << " and " << b;
    }
  }
}

struct Pattern {
  std::string name;
  std::function<cv::Mat(cv::Size, std::mt19937&)> generate;

  friend void PrintTo(const Pattern& pattern, std::ostream* out) { *out << pattern.name; }
};

class StrengthOfPattern : public ::testing::TestWithParam<Pattern> {};

TEST_P(StrengthOfPattern, HasTheBitsOfTheLiteralIteration) {
  const std::vector<cv::Size> sizes{{1, 1},  {1, 9},   {9, 1},   {2, 2},   {3, 3},
                                    {5, 4},  {9, 9},   {10, 23}, {18, 40}, {33, 17},
                                    {24, 9}, {41, 40}, {64, 48}, {97, 61}};
  std::mt19937 random(15);
  for (const cv::Size& size : sizes) {
    const cv::Mat channel = GetParam().generate(size, random);
    for (int scale = 1; scale <= 4; ++scale) {
      SCOPED_TRACE(::testing::Message() << size << " scale " << scale);
      ExpectSameBits(PropagateStrength(channel, scale), LiteralStrength(channel, scale));
    }
  }
}

TEST_P(StrengthOfPattern, HasTheBitsOfTheLiteralIterationAtTheLargestScale) {
  std::mt19937 random(8);
  const cv::Mat channel = GetParam().generate({71, 45}, random);
  ExpectSameBits(PropagateStrength(channel, 8), LiteralStrength(channel, 8));
}

INSTANTIATE_TEST_SUITE_P(Patterns, StrengthOfPattern,
                         ::testing::Values(Pattern{"Noise", testing::Noise},
                                           Pattern{"Gradient", testing::Gradient},
                                           Pattern{"Plateaus", testing::Plateaus},
                                           Pattern{"Spiral", testing::Spiral}),
                         [](const auto& instance) { return instance.param.name; });

TEST(PropagateStrength, IsOneEverywhereOnAConstantChannel) {
  const cv::Mat channel(40, 50, CV_8U, cv::Scalar(77));
  ExpectSameBits(PropagateStrength(channel, 3), cv::Mat::ones(40, 50, CV_32F));
}

TEST(PropagateStrength, FallsByTheContrastOfAStep) {
  const cv::Rect patch(6, 6, 8, 8);
  for (int contrast = 0; contrast <= 255; ++contrast) {
    SCOPED_TRACE(::testing::Message() << "contrast " << contrast);
    cv::Mat channel = cv::Mat::zeros(20, 20, CV_8U);
    channel(patch) = contrast;
    cv::Mat expected = cv::Mat::ones(20, 20, CV_32F);
    expected(patch) = 1.0F - static_cast<float>(contrast) / 255.0F;
    ExpectSameBits(PropagateStrength(channel, 1), expected);
  }
}

TEST(PropagateStrength, TakesAPartOfALargerImage) {
  std::mt19937 random(3);
  const cv::Mat whole = testing::Plateaus({60, 60}, random);
  const cv::Mat part = whole(cv::Rect(7, 5, 33, 41));
  ExpectSameBits(PropagateStrength(part, 2), PropagateStrength(part.clone(), 2));
}

TEST(PropagateStrength, HasTheBitsOfTheLiteralIterationOnHalfARealFrame) {
  const std::string name = "osd/learn0_color.png";
  const auto rgb = testing::ReadColor(name);
  if (!rgb) GTEST_SKIP() << MissingData(name);
  cv::Mat lab, half;
  cv::resize(*rgb, half, rgb->size() / 2, 0, 0, cv::INTER_AREA);
  cv::cvtColor(half, lab, cv::COLOR_RGB2Lab);
  cv::Mat lightness;
  cv::extractChannel(lab, lightness, 0);
  ExpectSameBits(PropagateStrength(lightness, 2), LiteralStrength(lightness, 2));
}

}  // namespace
}  // namespace fovea
