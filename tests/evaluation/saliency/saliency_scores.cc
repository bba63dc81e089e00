#include "tests/evaluation/saliency/saliency_scores.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "tests/evaluation/saliency/map_filters.h"
#include "tests/support/random.h"

namespace fovea::evaluation {
namespace {

constexpr int kNumSplits = 100;
constexpr double kThresholdsPerUnit = 10;

double ShareFrom(const std::vector<float>& values, double threshold) {
  const auto reached =
      std::count_if(values.begin(), values.end(), [&](float value) { return value >= threshold; });
  return static_cast<double>(reached) / static_cast<double>(values.size());
}

float Largest(const std::vector<float>& values) {
  return *std::max_element(values.begin(), values.end());
}

}  // namespace

double AreaUnderRoc(const std::vector<float>& at_fixations, const std::vector<float>& elsewhere) {
  const double most = std::max(Largest(at_fixations), Largest(elsewhere));
  double area = 0, hits = 0, false_alarms = 0;
  const auto move_to = [&](double next_hits, double next_false_alarms) {
    area += (next_false_alarms - false_alarms) * (next_hits + hits) / 2;
    hits = next_hits;
    false_alarms = next_false_alarms;
  };
  for (int k = static_cast<int>(std::floor(most * kThresholdsPerUnit)); k >= 0; --k) {
    const double threshold = k / kThresholdsPerUnit;
    move_to(ShareFrom(at_fixations, threshold), ShareFrom(elsewhere, threshold));
  }
  move_to(1, 1);
  return area;
}

double AucBorji(const cv::Mat& map, const std::vector<cv::Point>& fixations, std::uint64_t seed) {
  const cv::Mat scaled = ScaleToUnit(map);
  std::vector<float> at_fixations, elsewhere(fixations.size());
  for (const cv::Point& pixel : fixations) at_fixations.push_back(scaled.at<float>(pixel));
  scenes::Random random(seed);
  double sum = 0;
  for (int split = 0; split < kNumSplits; ++split) {
    for (float& value : elsewhere) {
      const int x = random.Integer(0, scaled.cols - 1), y = random.Integer(0, scaled.rows - 1);
      value = scaled.at<float>(y, x);
    }
    sum += AreaUnderRoc(at_fixations, elsewhere);
  }
  return sum / kNumSplits;
}

double Nss(const cv::Mat& map, const std::vector<cv::Point>& fixations) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(map, mean, deviation);
  if (deviation[0] == 0) return 0;
  const auto count = static_cast<double>(map.total());
  double sum = 0;
  for (const cv::Point& pixel : fixations) sum += map.at<float>(pixel) - mean[0];
  const double sample_deviation = deviation[0] * std::sqrt(count / (count - 1));
  return sum / static_cast<double>(fixations.size()) / sample_deviation;
}

double Correlation(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat a_centered, b_centered;
  cv::subtract(a, cv::mean(a), a_centered, {}, CV_64F);
  cv::subtract(b, cv::mean(b), b_centered, {}, CV_64F);
  const double product = cv::norm(a_centered) * cv::norm(b_centered);
  return product > 0 ? a_centered.dot(b_centered) / product : 0;
}

cv::Mat FixationDensity(const std::vector<cv::Point>& fixations, const cv::Size& size,
                        double sigma_px) {
  cv::Mat density = cv::Mat::zeros(size, CV_32F);
  for (const cv::Point& pixel : fixations) density.at<float>(pixel) = 1;
  return Blur(density, sigma_px, cv::BORDER_CONSTANT);
}

}  // namespace fovea::evaluation
