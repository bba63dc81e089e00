#include "tests/support/sensor.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "tests/support/random.h"
#include "tests/support/sensor_noise.h"

namespace fovea::scenes {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

constexpr double kKinectBaseline_m = 0.075;
constexpr double kKinectStep_m = 8 * 580 * kKinectBaseline_m;  // z = this / disparity in steps
constexpr double kKinectNoise_steps = 0.5;

void LimitRange(cv::Mat& depth_m, double nearest_m, double farthest_m) {
  depth_m.setTo(kNone, (depth_m < nearest_m) | (depth_m > farthest_m));
}

void RoundToMillimetres(cv::Mat& depth_m) {
  for (auto depth = depth_m.begin<float>(); depth != depth_m.end<float>(); ++depth) {
    if (!std::isnan(*depth)) *depth = static_cast<float>(std::round(*depth * 1000.0) / 1000.0);
  }
}

cv::Mat MeasureWithKinect(const Rendering& rendering, Random& random) {
  cv::Mat depth_m = WithLateralNoise(rendering.depth_m, random);
  // The correlation window makes most of the noise common to neighbours.
  const cv::Mat noise = std::sqrt(0.6) * Noise(depth_m.size(), 1.5, random) +
                        std::sqrt(0.4) * Noise(depth_m.size(), 0, random);
  for (int y = 0; y < depth_m.rows; ++y) {
    for (int x = 0; x < depth_m.cols; ++x) {
      float& depth = depth_m.at<float>(y, x);
      if (std::isnan(depth)) continue;
      const double steps = kKinectStep_m / depth + kKinectNoise_steps * noise.at<float>(y, x);
      depth = static_cast<float>(kKinectStep_m / std::max(1.0, std::round(steps)));
    }
  }
  // Disparity runs along rows: upright edges lose a broad band, level ones hardly any.
  ErodeEdges(depth_m, DepthEdges(rendering.depth_m, {3, 1}), 1, 4, random);
  ErodeEdges(depth_m, DepthEdges(rendering.depth_m, {3, 3}), 0, 1.5, random);
  depth_m.setTo(kNone, rendering.in_second_view == 0);
  depth_m.setTo(kNone, rendering.cosine < std::cos(80 * std::numbers::pi / 180));
  LimitRange(depth_m, 0.5, 8);
  return depth_m;
}

// 255 where active stereo finds nothing to match: dark places, and blobs of plain ones.
cv::Mat Unmatched(const Rendering& rendering, Random& random) {
  cv::Mat luminance, mean, mean_square;
  cv::cvtColor(rendering.color, luminance, cv::COLOR_RGB2GRAY);
  cv::boxFilter(luminance, mean, CV_32F, {9, 9});
  cv::sqrBoxFilter(luminance, mean_square, CV_32F, {9, 9});
  const cv::Mat contrast = mean_square - mean.mul(mean);
  const cv::Mat blobs = Noise(luminance.size(), 3, random);
  return (luminance < 0.02 + 0.007 * blobs) | ((contrast < 1e-5) & (blobs > 2.6));
}

cv::Mat MeasureWithStereo(const Rendering& rendering, SensorKind sensor, double focal_length_px,
                          Random& random) {
  const cv::Mat edges_m = sensor == SensorKind::kHaloStereo
                              ? WithHalos(rendering.depth_m, focal_length_px, random)
                              : rendering.depth_m;
  cv::Mat depth_m = WithStereoNoise(edges_m, focal_length_px, random);
  depth_m.setTo(kNone, rendering.in_second_view == 0);
  depth_m.setTo(kNone, rendering.cosine < std::cos(85 * std::numbers::pi / 180));
  depth_m.setTo(kNone, Unmatched(rendering, random));
  LimitRange(depth_m, 0.3, 6);
  return depth_m;
}

}  // namespace

double BaselineOf(SensorKind sensor) {
  switch (sensor) {
    case SensorKind::kKinect:
      return kKinectBaseline_m;
    case SensorKind::kRealSense:
    case SensorKind::kHaloStereo:
      return kStereoBaseline_m;
    case SensorKind::kIdeal:
      break;
  }
  return 0;
}

double DepthNoise_m(SensorKind sensor, double depth_m, double focal_length_px) {
  const double squared = depth_m * depth_m;
  switch (sensor) {
    case SensorKind::kKinect:  // noise, and rounding to whole steps
      return squared / kKinectStep_m *
             std::sqrt(kKinectNoise_steps * kKinectNoise_steps + 1.0 / 12);
    case SensorKind::kRealSense:
    case SensorKind::kHaloStereo:
      return squared * kStereoNoise_px / (focal_length_px * kStereoBaseline_m);
    case SensorKind::kIdeal:
      break;
  }
  return 0;
}

cv::Mat MeasureDepth(const Rendering& rendering, SensorKind sensor, double focal_length_px,
                     std::uint64_t seed) {
  Random random(seed);
  if (sensor == SensorKind::kIdeal) return rendering.depth_m.clone();
  cv::Mat depth_m = sensor == SensorKind::kKinect
                        ? MeasureWithKinect(rendering, random)
                        : MeasureWithStereo(rendering, sensor, focal_length_px, random);
  RoundToMillimetres(depth_m);
  return depth_m;
}

cv::Mat MeasureColor(const Rendering& rendering, SensorKind sensor, std::uint64_t seed) {
  Random random(seed);
  cv::Mat blurred, color_rgb(rendering.color.size(), CV_8UC3);
  cv::GaussianBlur(rendering.color, blurred, {}, 0.7);
  const double noise = sensor == SensorKind::kIdeal ? 0 : 2.5;
  for (int y = 0; y < blurred.rows; ++y) {
    for (int x = 0; x < blurred.cols; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        const double linear = std::clamp(blurred.at<cv::Vec3f>(y, x)[channel], 0.0F, 1.0F);
        color_rgb.at<cv::Vec3b>(y, x)[channel] = cv::saturate_cast<std::uint8_t>(
            255 * std::pow(linear, 1 / 2.2) + noise * random.Normal());
      }
    }
  }
  return color_rgb;
}

}  // namespace fovea::scenes
