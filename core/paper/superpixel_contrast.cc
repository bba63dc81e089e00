#include "core/paper/superpixel_contrast.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "core/paper/superpixels.h"
#include "core/saliency/nearness.h"
#include "core/types/interruption.h"

namespace fovea::paper {
namespace {

constexpr float kCompactness = 20;  // of superpixels, where the nearness spans 0 to 255

// Ju's contribution of one scan line to a superpixel.
float LineContrast(const cv::Mat& nearness, const Superpixel& center, const ScanLine& line) {
  const cv::Rect image({0, 0}, nearness.size());
  cv::Point sample(static_cast<int>(std::lround(center.x_px)),
                   static_cast<int>(std::lround(center.y_px)));
  float least = center.value;
  for (int i = 0; i < line.count; ++i) {
    sample += line.step;
    if (!image.contains(sample)) break;
    least = std::min(least, nearness.at<float>(sample));
  }
  return center.value - least;
}

// At least one pixel must have depth.
cv::Mat ContrastOf(int count, const cv::Mat& nearness, const std::array<ScanLine, 8>& lines) {
  double least = 0, most = 0;
  cv::minMaxLoc(nearness, &least, &most, nullptr, nullptr, nearness != kNoNearness);
  const auto compactness = static_cast<float>(kCompactness / 255.0 * (most - least));
  const Superpixels superpixels = DivideIntoSuperpixels(nearness, count, compactness);

  std::vector<float> contrasts;
  LongLoop loop;
  for (const Superpixel& center : superpixels.all) {
    loop.Turn();
    float sum = 0;
    if (center.pixels > 0) {
      for (const ScanLine& line : lines) sum += LineContrast(nearness, center, line);
    }
    contrasts.push_back(sum);
  }
  cv::Mat contrast = cv::Mat::zeros(nearness.size(), CV_32F);
  for (int y = 0; y < contrast.rows; ++y) {
    InterruptionPoint();
    const int* labels = superpixels.labels.ptr<int>(y);
    float* to = contrast.ptr<float>(y);
    for (int x = 0; x < contrast.cols; ++x) {
      if (labels[x] >= 0) to[x] = contrasts[static_cast<std::size_t>(labels[x])];
    }
  }
  return contrast;
}

}  // namespace

Contrast ContrastOfSuperpixels(double per_diagonal) {
  return [per_diagonal](const cv::Mat& nearness, const std::array<ScanLine, 8>& lines) {
    const auto count =
        static_cast<int>(std::lround(per_diagonal * std::hypot(nearness.cols, nearness.rows)));
    return count > 0 ? ContrastOf(count, nearness, lines) : ContrastOfPixels(nearness, lines);
  };
}

}  // namespace fovea::paper
