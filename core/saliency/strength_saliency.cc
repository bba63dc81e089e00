#include "core/saliency/strength_saliency.h"

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "core/saliency/blocks.h"
#include "core/types/interruption.h"
#include "core/types/lab.h"

namespace fovea {
namespace {

void Accumulate(const cv::Mat& strength, cv::Mat& saliency) {
  for (int y = 0; y < saliency.rows; ++y) {
    const float* from = strength.ptr<float>(y);
    float* to = saliency.ptr<float>(y);
    for (int x = 0; x < saliency.cols; ++x) to[x] += 1.0F - from[x];
  }
}

// In a fixed order, unlike cv::norm: the sum must not depend on the machine's vector width.
void NormalizeL2(cv::Mat& map) {
  InterruptionPoint();
  double sum = 0;
  for (int y = 0; y < map.rows; ++y) {
    const float* row = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) sum += static_cast<double>(row[x]) * row[x];
  }
  if (sum == 0) return;
  const auto norm = static_cast<float>(std::sqrt(sum));
  for (int y = 0; y < map.rows; ++y) {
    float* row = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) row[x] /= norm;
  }
}

}  // namespace

cv::Mat StrengthSaliency(const cv::Mat& color_rgb, const StrengthSaliencyOptions& options) {
  const cv::Mat lab = LabOf(ReduceByBlocks(color_rgb, options.downscale));
  std::vector<cv::Mat> channels;
  cv::split(lab, channels);
  if (options.stretch) {
    for (cv::Mat& channel : channels) cv::normalize(channel, channel, 0, 255, cv::NORM_MINMAX);
  }

  cv::Mat saliency = cv::Mat::zeros(lab.size(), CV_32F);
  for (int scale = 1; scale <= options.num_scales; ++scale) {
    for (const cv::Mat& channel : channels) {
      InterruptionPoint();
      Accumulate(PropagateStrength(channel, scale), saliency);
    }
  }
  InterruptionPoint();
  saliency = EnlargeBlocks(saliency, options.downscale, color_rgb.size());
  NormalizeL2(saliency);
  return saliency;
}

}  // namespace fovea
