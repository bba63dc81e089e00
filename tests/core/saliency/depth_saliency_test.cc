#include "core/saliency/depth_saliency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

namespace fovea {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
const DepthSaliencyOptions kPlain{.depth_prior = false};

// --- The method word for word, pixel by pixel ----------------------------------------------------

bool HasDepth(float depth) { return std::isfinite(depth) && depth > 0; }

// 1/depth under a Gaussian of 7×7 pixels, σ = 1.75 px, over the pixels that have depth.
cv::Mat_<double> LiteralNearness(const cv::Mat_<float>& depth) {
  cv::Mat_<double> nearness(depth.size(), std::numeric_limits<double>::quiet_NaN());
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      if (!HasDepth(depth(y, x))) continue;
      double sum = 0, weights = 0;
      for (int j = std::max(y - 3, 0); j <= std::min(y + 3, depth.rows - 1); ++j) {
        for (int i = std::max(x - 3, 0); i <= std::min(x + 3, depth.cols - 1); ++i) {
          if (!HasDepth(depth(j, i))) continue;
          const double distance2 = (j - y) * (j - y) + (i - x) * (i - x);
          const double weight = std::exp(-distance2 / (2 * 1.75 * 1.75));
          sum += weight / depth(j, i);
          weights += weight;
        }
      }
      nearness(y, x) = sum / weights;
    }
  }
  return nearness;
}

double LiteralContrast(const cv::Mat_<double>& nearness, cv::Point pixel,
                       const DepthSaliencyOptions& options) {
  const cv::Rect image({0, 0}, nearness.size());
  const double length = options.line_length * std::hypot(nearness.cols, nearness.rows);
  const int straight = options.line_step_px;
  const int diagonal = std::max(1, static_cast<int>(std::lround(straight / std::sqrt(2.0))));
  double sum = 0;
  for (int direction = 0; direction < 9; ++direction) {
    const cv::Point unit(direction % 3 - 1, direction / 3 - 1);
    if (unit == cv::Point(0, 0)) continue;
    const cv::Point step = unit * (unit.x == 0 || unit.y == 0 ? straight : diagonal);
    double least = nearness(pixel);
    for (int k = 1; k * std::hypot(step.x, step.y) <= length; ++k) {
      const cv::Point sample = pixel + step * k;
      if (!image.contains(sample)) break;
      if (nearness(sample) < least) least = nearness(sample);  // never where it is NaN
    }
    sum += nearness(pixel) - least;
  }
  return sum;
}

cv::Mat LiteralSaliency(const cv::Mat& depth, const DepthSaliencyOptions& options) {
  const cv::Mat_<double> nearness = LiteralNearness(depth);
  std::vector<double> values;
  for (const double value : nearness) {
    if (!std::isnan(value)) values.push_back(value);
  }
  std::sort(values.begin(), values.end());

  cv::Mat_<double> saliency = cv::Mat_<double>::zeros(depth.size());
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      if (!std::isnan(nearness(y, x))) saliency(y, x) = LiteralContrast(nearness, {x, y}, options);
    }
  }
  double most = 0;
  cv::minMaxLoc(saliency, nullptr, &most);
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      double& value = saliency(y, x);
      value /= most;
      const double threshold = values[values.size() / 2];
      if (options.depth_prior && nearness(y, x) < threshold) value *= nearness(y, x) / threshold;
      const double down = (y - (depth.rows - 1) / 2.0) / (depth.rows / 2.0);
      const double across = (x - (depth.cols - 1) / 2.0) / (depth.cols / 2.0);
      if (options.center_prior) value *= std::exp(-down * down - across * across);
    }
  }
  cv::Mat result;
  saliency.convertTo(result, CV_32F);
  return result;
}

// --- Scenes --------------------------------------------------------------------------------------

// A slanted table with boxes on it, some noise, and holes.
cv::Mat GeneratedDepth(cv::Size size, unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](int end) {
    return static_cast<int>(random() % static_cast<unsigned>(end));
  };
  cv::Mat depth(size, CV_32F);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float noise = 0.001F * static_cast<float>(below(10));
      depth.at<float>(y, x) = 1.5F - 0.7F * static_cast<float>(y) / size.height + noise;
    }
  }
  const cv::Rect image({0, 0}, size);
  for (int i = 0; i < 6; ++i) {
    cv::Mat part = depth(cv::Rect(below(size.width), below(size.height), 9, 12) & image);
    if (i % 3 == 0) {
      part = kNaN;
    } else {
      part -= 0.1;
    }
  }
  return depth;
}

cv::Mat BoxOnAPlane(cv::Rect box) {
  cv::Mat depth(60, 80, CV_32F, cv::Scalar(2));
  depth(box) = 1.0F;
  return depth;
}

float Deviation(const cv::Mat& a, const cv::Mat& b) {
  return static_cast<float>(cv::norm(a, b, cv::NORM_INF));
}

// --- Tests ---------------------------------------------------------------------------------------

TEST(DepthSaliency, OfPixelsIsTheLiteralMethod) {
  std::vector<DepthSaliencyOptions> cases(6, kPlain);
  cases[1].depth_prior = true;
  cases[2].center_prior = true;
  cases[3].line_step_px = 1;
  cases[4].line_length = 0.1;
  cases[5].line_step_px = 8;
  cases[5].line_length = 1.0;
  for (const cv::Size& size :
       {cv::Size(64, 48), cv::Size(37, 51), cv::Size(30, 1), cv::Size(3, 2)}) {
    const cv::Mat depth = GeneratedDepth(size, 2014);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      SCOPED_TRACE(testing::Message() << size << " case " << i);
      EXPECT_LT(Deviation(DepthSaliency(depth, cases[i]), LiteralSaliency(depth, cases[i])), 2e-4F);
    }
  }
}

TEST(DepthSaliency, OfABoxIsOneOnItsTopAndZeroOnThePlane) {
  const cv::Rect box(30, 20, 20, 20);
  const cv::Mat saliency = DepthSaliency(BoxOnAPlane(box), kPlain);
  EXPECT_FLOAT_EQ(saliency.at<float>(30, 40), 1.0F);  // 8 · (1/1 − 1/2), the most there is
  EXPECT_NEAR(saliency.at<float>(5, 5), 0.0F, 1e-5F);
  EXPECT_NEAR(saliency.at<float>(50, 70), 0.0F, 1e-5F);
}

TEST(DepthSaliency, OfAHollowIsZeroInIt) {
  cv::Mat depth(60, 80, CV_32F, cv::Scalar(1));
  depth(cv::Rect(30, 20, 20, 20)) = 2.0F;
  const cv::Mat saliency = DepthSaliency(depth, kPlain);
  EXPECT_NEAR(saliency.at<float>(30, 40), 0.0F, 1e-5F);
  // Right of the hollow only the line to the left meets it; at its corner at most three lines do.
  EXPECT_GT(saliency.at<float>(30, 60), 0.1F);
}

TEST(DepthSaliency, IsZeroOnConstantDepth) {
  const cv::Mat depth(30, 40, CV_32F, cv::Scalar(1.3));
  EXPECT_EQ(cv::countNonZero(DepthSaliency(depth)), 0);
}

TEST(DepthSaliency, IsZeroWhereThereIsNoDepth) {
  const cv::Mat none(30, 40, CV_32F, cv::Scalar(kNaN));
  EXPECT_EQ(cv::countNonZero(DepthSaliency(none)), 0);

  cv::Mat depth = BoxOnAPlane({30, 20, 20, 20});
  depth(cv::Rect(0, 0, 80, 15)) = kNaN;
  depth(cv::Rect(35, 25, 4, 4)) = kNaN;
  const cv::Mat saliency = DepthSaliency(depth);
  EXPECT_TRUE(cv::checkRange(saliency, true, nullptr, 0.0, 1.0 + 1e-6));
  EXPECT_EQ(cv::countNonZero(saliency(cv::Rect(0, 0, 80, 15))), 0);
  EXPECT_EQ(cv::countNonZero(saliency(cv::Rect(35, 25, 4, 4))), 0);
}

// A hole is not a far place: what is seen through it is unknown.
TEST(DepthSaliency, IsNotRaisedByAHoleNearby) {
  cv::Mat depth = BoxOnAPlane({50, 30, 10, 10});
  const cv::Mat before = DepthSaliency(depth, kPlain);
  depth(cv::Rect(10, 10, 12, 12)) = kNaN;
  const cv::Mat after = DepthSaliency(depth, kPlain);
  EXPECT_NEAR(after.at<float>(16, 26), before.at<float>(16, 26), 1e-5F);
}

TEST(DepthSaliency, FallsBehindTheNearerHalfWithTheDepthPrior) {
  cv::Mat depth(60, 80, CV_32F, cv::Scalar(1));
  depth.rowRange(0, 25) = 4.0F;           // less than half of the image
  depth(cv::Rect(30, 5, 10, 10)) = 2.0F;  // stands out, but behind
  const cv::Mat plain = DepthSaliency(depth, kPlain);
  const cv::Mat weighted = DepthSaliency(depth);
  EXPECT_NEAR(weighted.at<float>(10, 35), 0.5F * plain.at<float>(10, 35), 0.02F);
  EXPECT_FLOAT_EQ(weighted.at<float>(40, 40), plain.at<float>(40, 40));
}

TEST(DepthSaliency, FallsTowardsTheBorderWithTheCenterPrior) {
  DepthSaliencyOptions options = kPlain;
  options.center_prior = true;
  const cv::Mat depth = BoxOnAPlane({5, 5, 12, 12});
  const cv::Mat plain = DepthSaliency(depth, kPlain);
  const cv::Mat weighted = DepthSaliency(depth, options);
  const double down = (10 - 29.5) / 30, across = (10 - 39.5) / 40;
  const auto weight = static_cast<float>(std::exp(-down * down - across * across));
  EXPECT_NEAR(weighted.at<float>(10, 10), weight * plain.at<float>(10, 10), 1e-5F);
}

TEST(DepthSaliency, IsTheMapOfTheReducedDepthInFlatBlocks) {
  const cv::Mat depth = BoxOnAPlane({24, 20, 20, 20});
  DepthSaliencyOptions options = kPlain;
  options.line_step_px = 4;
  options.downscale = 2;
  const cv::Mat map = DepthSaliency(depth, options);
  options.downscale = 1;
  options.line_step_px = 2;
  cv::Mat reduced, enlarged;
  cv::resize(depth, reduced, depth.size() / 2, 0, 0, cv::INTER_AREA);
  cv::resize(DepthSaliency(reduced, options), enlarged, depth.size(), 0, 0, cv::INTER_NEAREST);
  EXPECT_LT(cv::norm(map, enlarged, cv::NORM_INF), 1e-5);
}

TEST(DepthSaliency, KeepsTheSizeWhereTheReductionDoesNotDivideIt) {
  const cv::Mat depth = GeneratedDepth({47, 31}, 5);
  EXPECT_EQ(DepthSaliency(depth, {.downscale = 4}).size(), depth.size());
}

TEST(DepthSaliency, AnswersTheSameEveryTime) {
  const cv::Mat depth = GeneratedDepth({120, 90}, 5);
  EXPECT_EQ(Deviation(DepthSaliency(depth), DepthSaliency(depth)), 0.0F);
}

}  // namespace
}  // namespace fovea
