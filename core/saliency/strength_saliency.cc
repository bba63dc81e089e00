#include "core/saliency/strength_saliency.h"

#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "core/types/blocks.h"
#include "core/types/helpers.h"
#include "core/types/interruption.h"
#include "core/types/lab.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

// The sum of 1 − S over all of them, in their order.
cv::Mat SumOfContrasts(const std::vector<cv::Mat>& strengths) {
  InterruptionPoint();
  cv::Mat sum = cv::Mat::zeros(strengths.front().size(), CV_32F);
  RunInWidestRegisters([&] {
    for (int y = 0; y < sum.rows; ++y) {
      float* to = sum.ptr<float>(y);
      for (const cv::Mat& strength : strengths) {
        const float* from = strength.ptr<float>(y);
        for (int x = 0; x < sum.cols; ++x) to[x] += 1.0F - from[x];
      }
    }
  });
  return sum;
}

// At all scales, of all channels.
std::vector<cv::Mat> PropagateAll(const std::vector<cv::Mat>& channels, int num_scales) {
  std::vector<cv::Mat> strengths(channels.size() * static_cast<std::size_t>(num_scales));
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < strengths.size(); ++i) {
    tasks.emplace_back([&, i] {
      InterruptionPoint();
      const int scale = 1 + static_cast<int>(i / channels.size());
      strengths[i] = PropagateStrength(channels[i % channels.size()], scale);
    });
  }
  RunTogether(tasks);
  return strengths;
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

  cv::Mat saliency = SumOfContrasts(PropagateAll(channels, options.num_scales));
  NormalizeL2(saliency);
  return EnlargeBlocks(saliency, options.downscale, color_rgb.size());
}

}  // namespace fovea
