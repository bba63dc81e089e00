#include "tests/support/sensor_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace fovea::scenes {

cv::Mat Noise(const cv::Size& size, double sigma_px, Random& random) {
  cv::Mat noise(size, CV_32FC1);
  for (auto value = noise.begin<float>(); value != noise.end<float>(); ++value) {
    *value = static_cast<float>(random.Normal());
  }
  if (sigma_px <= 0) return noise;
  cv::GaussianBlur(noise, noise, {}, sigma_px, sigma_px, cv::BORDER_REFLECT);
  return noise * (2 * std::sqrt(std::numbers::pi) * sigma_px);  // what the blur took away
}

cv::Mat DepthEdges(const cv::Mat& depth_m, const cv::Size& window) {
  cv::Mat known = depth_m.clone(), nearest, farthest;
  cv::patchNaNs(known, 100);
  const cv::Mat neighbours = cv::Mat::ones(window, CV_8UC1);
  cv::erode(known, nearest, neighbours);
  cv::dilate(known, farthest, neighbours);
  return farthest - nearest > 0.02 + 0.01 * nearest;
}

void ErodeEdges(cv::Mat& depth_m, const cv::Mat& edges, double low, double high, Random& random) {
  cv::Mat distance;
  cv::distanceTransform(edges == 0, distance, cv::DIST_L2, cv::DIST_MASK_5);
  const cv::Mat noise = Noise(edges.size(), 2, random);
  const cv::Mat width = (low + high) / 2 + (high - low) / 4 * noise;
  depth_m.setTo(std::numeric_limits<float>::quiet_NaN(),
                distance < cv::min(cv::max(width, low), high));
}

cv::Mat WithStereoNoise(const cv::Mat& depth_m, double focal_length_px, Random& random) {
  constexpr float kFar_m = 100;  // stands for none
  cv::Mat noisy = depth_m.clone();
  cv::patchNaNs(noisy, kFar_m);
  cv::Mat fattened;  // matching windows give the edge to whoever is nearer
  cv::erode(noisy, fattened, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
  fattened.copyTo(noisy, noisy - fattened > 0.02 + 0.01 * fattened);
  const cv::Mat none = noisy == kFar_m;

  const cv::Mat noise = std::sqrt(0.9) * Noise(noisy.size(), 5, random) +
                        std::sqrt(0.1) * Noise(noisy.size(), 1, random);
  const double scale = kStereoNoise_px / (focal_length_px * kStereoBaseline_m);
  noisy += scale * noisy.mul(noisy).mul(noise);
  noisy.setTo(std::numeric_limits<float>::quiet_NaN(), none);
  return noisy;
}

cv::Mat WithHalos(const cv::Mat& depth_m, double focal_length_px, Random& random) {
  constexpr double kSlope_px = 2.5,
                   kLargestStep_px = 8;  // of disparity, beyond which it breaks off
  cv::Mat disparity_px = focal_length_px * kStereoBaseline_m / depth_m;
  cv::patchNaNs(disparity_px, 0);
  cv::Mat fattened_px, sloping_px;
  cv::dilate(disparity_px, fattened_px, cv::getStructuringElement(cv::MORPH_ELLIPSE, {9, 7}));
  cv::GaussianBlur(fattened_px, sloping_px, {}, kSlope_px);
  const cv::Mat reach_px = kLargestStep_px + Noise(depth_m.size(), 4, random);
  const cv::Mat close = (fattened_px - disparity_px < reach_px) & (disparity_px > 0);
  cv::max(disparity_px, sloping_px, sloping_px);
  sloping_px.copyTo(disparity_px, close);
  cv::Mat smeared_m = focal_length_px * kStereoBaseline_m / disparity_px;
  smeared_m.setTo(std::numeric_limits<float>::quiet_NaN(), disparity_px <= 0);
  return smeared_m;
}

cv::Mat WithLateralNoise(const cv::Mat& depth_m, Random& random) {
  cv::Mat moved(depth_m.size(), CV_32FC1);
  for (int y = 0; y < depth_m.rows; ++y) {
    for (int x = 0; x < depth_m.cols; ++x) {
      const int dx = static_cast<int>(std::lround(0.5 * random.Normal()));
      const int dy = static_cast<int>(std::lround(0.5 * random.Normal()));
      moved.at<float>(y, x) = depth_m.at<float>(std::clamp(y + dy, 0, depth_m.rows - 1),
                                                std::clamp(x + dx, 0, depth_m.cols - 1));
    }
  }
  return moved;
}

}  // namespace fovea::scenes
