#include "core/saliency/strength_saliency.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <vector>

#include "tests/support/data_path.h"

namespace fovea {
namespace {

// --- Algorithm 1 of the paper, word for word -----------------------------------------------------

float LiteralFactor(int a, int b) {
  const auto difference = static_cast<float>(std::abs(a - b));
  return 1.0F - difference / 255.0F;
}

std::vector<cv::Point> Ring(int scale) {
  std::vector<cv::Point> offsets;
  for (int y = -scale; y <= scale; ++y) {
    for (int x = -scale; x <= scale; ++x) {
      if (std::max(std::abs(x), std::abs(y)) == scale) offsets.emplace_back(x, y);
    }
  }
  return offsets;
}

// Every pixel takes its new strength from all the old ones, again and again.
cv::Mat LiteralStrength(const cv::Mat& channel, int scale) {
  const std::vector<cv::Point> ring = Ring(scale);
  cv::Mat strength = cv::Mat::ones(channel.size(), CV_32F);
  std::vector<cv::Point> inside;
  for (int y = scale; y < channel.rows - scale; ++y) {
    for (int x = scale; x < channel.cols - scale; ++x) {
      inside.emplace_back(x, y);
      strength.at<float>(y, x) = 0;
    }
  }
  for (bool changed = true; changed;) {
    changed = false;
    const cv::Mat before = strength.clone();
    for (const cv::Point& i : inside) {
      float most = 0;
      for (const cv::Point& offset : ring) {
        const cv::Point j = i + offset;
        const float factor =
            LiteralFactor(channel.at<std::uint8_t>(i), channel.at<std::uint8_t>(j));
        most = std::max(most, before.at<float>(j) * factor);
      }
      changed |= most != strength.at<float>(i);
      strength.at<float>(i) = most;
    }
  }
  return strength;
}

cv::Mat LiteralSaliency(const cv::Mat& color_rgb, int num_scales) {
  cv::Mat lab;
  cv::cvtColor(color_rgb, lab, cv::COLOR_RGB2Lab);
  std::array<cv::Mat, 3> channels;
  cv::split(lab, channels.data());
  cv::Mat sum = cv::Mat::zeros(color_rgb.size(), CV_32F);
  for (int scale = 1; scale <= num_scales; ++scale) {
    for (const cv::Mat& channel : channels) sum += 1.0 - LiteralStrength(channel, scale);
  }
  const double norm = cv::norm(sum, cv::NORM_L2);
  return norm > 0 ? cv::Mat(sum / norm) : sum;
}

// --- Images --------------------------------------------------------------------------------------

using Generator = std::function<cv::Mat(cv::Size, std::mt19937&)>;

cv::Mat Noise(cv::Size size, std::mt19937& random) {
  cv::Mat image(size, CV_8U);
  for (auto& value : cv::Mat_<std::uint8_t>(image)) {
    value = static_cast<std::uint8_t>(random() % 256);
  }
  return image;
}

cv::Mat Gradient(cv::Size size, std::mt19937& random) {
  const int across = static_cast<int>(random() % 7), down = static_cast<int>(random() % 7);
  cv::Mat image(size, CV_8U);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      image.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>((across * x + down * y) % 256);
    }
  }
  return image;
}

// Overlapping rectangles of few values: plateaus, and strengths that have to find a way round.
cv::Mat Plateaus(cv::Size size, std::mt19937& random) {
  cv::Mat image = cv::Mat::zeros(size, CV_8U);
  for (int i = 0; i < 40; ++i) {
    const cv::Point corner(static_cast<int>(random() % static_cast<unsigned>(size.width)),
                           static_cast<int>(random() % static_cast<unsigned>(size.height)));
    const cv::Size extent(1 + static_cast<int>(random() % 20), 1 + static_cast<int>(random() % 20));
    image(cv::Rect(corner, extent) & cv::Rect({0, 0}, size)) = 40.0 * (random() % 7);
  }
  return image;
}

// A one-pixel corridor that winds inwards: the longest paths a propagation can meet.
cv::Mat Spiral(cv::Size size, std::mt19937&) {
  cv::Mat image(size, CV_8U);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int rim = std::min({x, y, size.width - 1 - x, size.height - 1 - y});
      const bool gate = x == rim + 1 && y == rim + (rim / 2 % 2 == 0 ? 2 : size.height / 2 - rim);
      image.at<std::uint8_t>(y, x) = rim % 2 == 0 || gate ? 100 : 250;
    }
  }
  return image;
}

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

std::optional<cv::Mat> ReadColor(const std::string& name) {
  const auto path = DataPath(name);
  if (!path) return std::nullopt;
  cv::Mat rgb;
  cv::cvtColor(cv::imread(path->string()), rgb, cv::COLOR_BGR2RGB);
  return rgb;
}

// --- Strength of one channel ---------------------------------------------------------------------

struct Pattern {
  std::string name;
  Generator generate;

  friend void PrintTo(const Pattern& pattern, std::ostream* out) { *out << pattern.name; }
};

class StrengthOfPattern : public testing::TestWithParam<Pattern> {};

TEST_P(StrengthOfPattern, HasTheBitsOfTheLiteralIteration) {
  const std::vector<cv::Size> sizes{{1, 1},  {1, 9},   {9, 1},   {2, 2},   {3, 3},
                                    {5, 4},  {9, 9},   {10, 23}, {18, 40}, {33, 17},
                                    {24, 9}, {41, 40}, {64, 48}, {97, 61}};
  std::mt19937 random(15);
  for (const cv::Size& size : sizes) {
    const cv::Mat channel = GetParam().generate(size, random);
    for (int scale = 1; scale <= 4; ++scale) {
      SCOPED_TRACE(testing::Message() << size << " scale " << scale);
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
                         testing::Values(Pattern{"Noise", Noise}, Pattern{"Gradient", Gradient},
                                         Pattern{"Plateaus", Plateaus}, Pattern{"Spiral", Spiral}),
                         [](const auto& instance) { return instance.param.name; });

TEST(PropagateStrength, IsOneEverywhereOnAConstantChannel) {
  const cv::Mat channel(40, 50, CV_8U, cv::Scalar(77));
  ExpectSameBits(PropagateStrength(channel, 3), cv::Mat::ones(40, 50, CV_32F));
}

TEST(PropagateStrength, FallsByTheContrastOfAStep) {
  const cv::Rect patch(6, 6, 8, 8);
  for (int contrast = 0; contrast <= 255; ++contrast) {
    SCOPED_TRACE(testing::Message() << "contrast " << contrast);
    cv::Mat channel = cv::Mat::zeros(20, 20, CV_8U);
    channel(patch) = contrast;
    cv::Mat expected = cv::Mat::ones(20, 20, CV_32F);
    expected(patch) = 1.0F - static_cast<float>(contrast) / 255.0F;
    ExpectSameBits(PropagateStrength(channel, 1), expected);
  }
}

TEST(PropagateStrength, TakesAPartOfALargerImage) {
  std::mt19937 random(3);
  const cv::Mat whole = Plateaus({60, 60}, random);
  const cv::Mat part = whole(cv::Rect(7, 5, 33, 41));
  ExpectSameBits(PropagateStrength(part, 2), PropagateStrength(part.clone(), 2));
}

TEST(PropagateStrength, HasTheBitsOfTheLiteralIterationOnHalfARealFrame) {
  const std::string name = "osd/learn0_color.png";
  const auto rgb = ReadColor(name);
  if (!rgb) GTEST_SKIP() << MissingData(name);
  cv::Mat lab, half;
  cv::resize(*rgb, half, rgb->size() / 2, 0, 0, cv::INTER_AREA);
  cv::cvtColor(half, lab, cv::COLOR_RGB2Lab);
  cv::Mat lightness;
  cv::extractChannel(lab, lightness, 0);
  ExpectSameBits(PropagateStrength(lightness, 2), LiteralStrength(lightness, 2));
}

// --- The whole map -------------------------------------------------------------------------------

class SaliencyOfImage : public testing::TestWithParam<std::string> {};

TEST_P(SaliencyOfImage, IsTheNormalizedSumOverScalesAndChannels) {
  const auto rgb = ReadColor(GetParam());
  if (!rgb) GTEST_SKIP() << MissingData(GetParam());
  cv::Mat reduced;
  cv::resize(*rgb, reduced, {81, 60}, 0, 0, cv::INTER_AREA);
  const cv::Mat saliency = StrengthSaliency(reduced);
  EXPECT_LT(cv::norm(saliency, LiteralSaliency(reduced, 4), cv::NORM_INF), 1e-7);
  EXPECT_NEAR(cv::norm(saliency), 1.0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(RealImages, SaliencyOfImage,
                         testing::Values("osd/learn0_color.png", "osd/learn33_color.png",
                                         "osd/test56_color.png", "floor/floor1_color.png"),
                         [](const auto& instance) {
                           const std::string& name = instance.param;
                           return name.substr(name.find('/') + 1,
                                              name.find('_') - 1 - name.find('/'));
                         });

cv::Mat ColoredPatches(cv::Size size) {
  std::mt19937 random(12);
  std::array<cv::Mat, 3> channels;
  for (cv::Mat& channel : channels) channel = Plateaus(size, random);
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
