#include "tests/evaluation/saliency/saliency_scores.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tests/evaluation/saliency/map_filters.h"

namespace fovea::evaluation {
namespace {

TEST(AreaUnderRoc, IsTheShareOfPairsInOrderWhereThresholdsTellThemApart) {
  // 1 > 0.7, 1 > 0.2, 0.5 < 0.7, 0.5 > 0.2
  EXPECT_DOUBLE_EQ(AreaUnderRoc({1.0F, 0.5F}, {0.7F, 0.2F}), 0.75);
  EXPECT_DOUBLE_EQ(AreaUnderRoc({0.9F}, {0.1F, 0.3F, 0.2F}), 1);
  EXPECT_DOUBLE_EQ(AreaUnderRoc({0.1F}, {0.9F}), 0);
  EXPECT_DOUBLE_EQ(AreaUnderRoc({0.55F}, {0.52F}), 0.5) << "no multiple of 0.1 lies between them";
  EXPECT_DOUBLE_EQ(AreaUnderRoc({0.3F, 0.1F}, {0.3F, 0.0F}), 0.625) << "a tie counts half";
}

TEST(AucBorji, IsOneMinusHalfTheShareOfASalientAreaThatHoldsAllFixations) {
  // The curve goes (0, 0), (share, 1), (1, 1). The values need not lie in [0, 1].
  cv::Mat map(40, 100, CV_32F, cv::Scalar(-7));
  map.colRange(0, 30).setTo(3);
  std::vector<cv::Point> fixations;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 30; x += 3) fixations.emplace_back(x, y);
  }
  EXPECT_NEAR(AucBorji(map, fixations, 5), 0.85, 0.005);  // standard error 0.0011
  EXPECT_EQ(AucBorji(map, fixations, 5), AucBorji(map, fixations, 5));
  EXPECT_NE(AucBorji(map, fixations, 5), AucBorji(map, fixations, 6));
  EXPECT_DOUBLE_EQ(AucBorji(cv::Mat(40, 100, CV_32F, cv::Scalar(2)), fixations, 5), 0.5);
}

TEST(Nss, CountsInDeviationsOfTheSample) {
  const cv::Mat map = (cv::Mat_<float>(2, 2) << 0, 0, 0, 4);  // mean 1, deviation √(12/3)
  EXPECT_DOUBLE_EQ(Nss(map, {{1, 1}}), 1.5);
  EXPECT_DOUBLE_EQ(Nss(map, {{1, 1}, {0, 1}}), 0.5);
  EXPECT_DOUBLE_EQ(Nss(cv::Mat::ones(2, 2, CV_32F), {{1, 1}}), 0);
}

TEST(Correlation, IsPearsons) {
  const cv::Mat a = (cv::Mat_<float>(2, 2) << 1, 2, 3, 4),
                b = (cv::Mat_<float>(2, 2) << 1, 2, 3, 5);
  EXPECT_NEAR(Correlation(a, b), 6.5 / std::sqrt(5 * 8.75), 1e-12);
  EXPECT_NEAR(Correlation(a, 10 - 2 * a), -1, 1e-12);
  EXPECT_DOUBLE_EQ(Correlation(a, cv::Mat::ones(2, 2, CV_32F)), 0);
}

TEST(FixationDensity, IsAGaussianAboutEachFixation) {
  const cv::Mat density = FixationDensity({{30, 20}}, {60, 40}, 1.5);
  EXPECT_NEAR(cv::sum(density)[0], 1, 1e-5);
  EXPECT_NEAR(density.at<float>(20, 33) / density.at<float>(20, 30), std::exp(-2.0), 1e-3);
  EXPECT_EQ(density.at<float>(0, 0), 0);
}

TEST(Blur, OfAReducedMapIsCloseToTheExactOne) {
  cv::Mat map(150, 200, CV_32F);
  cv::RNG random(3);
  random.fill(map, cv::RNG::UNIFORM, 0, 1);
  map.rowRange(0, 60).setTo(1);
  for (const auto border : {cv::BORDER_CONSTANT, cv::BORDER_REFLECT}) {
    for (const double sigma_px : {1.0, 5.0, 8.0, 32.0}) {
      cv::Mat exact;
      cv::GaussianBlur(map, exact, {}, sigma_px, sigma_px, border);
      EXPECT_LT(cv::norm(Blur(map, sigma_px, border), exact, cv::NORM_INF), 0.03)
          << "sigma " << sigma_px;
    }
  }
  EXPECT_EQ(cv::norm(Blur(map, 0, cv::BORDER_CONSTANT), map, cv::NORM_INF), 0);
}

TEST(CenterPrior, FallsOffByShares) {
  const cv::Mat prior = CenterPrior({81, 41}, 0.25);
  EXPECT_FLOAT_EQ(prior.at<float>(20, 40), 1);
  EXPECT_FLOAT_EQ(prior.at<float>(20, 0), std::exp(-std::pow(40 / (0.25F * 81), 2.0F) / 2));
  EXPECT_FLOAT_EQ(prior.at<float>(0, 40), std::exp(-std::pow(20 / (0.25F * 41), 2.0F) / 2));
}

}  // namespace
}  // namespace fovea::evaluation
