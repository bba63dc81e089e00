#include "core/saliency/depth_saliency.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "core/saliency/nearness.h"
#include "core/types/blocks.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr double kLeastContrast = 1e-5;  // 1/m; a map that nowhere reaches it is rounding error

void ScaleToOne(cv::Mat& map) {
  InterruptionPoint();
  double most = 0;
  cv::minMaxLoc(map, nullptr, &most);
  if (most < kLeastContrast) {
    map = 0.0F;
    return;
  }
  for (int y = 0; y < map.rows; ++y) {
    float* row = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) row[x] /= static_cast<float>(most);
  }
}

// The nearness at which the nearer half of the pixels begins. Positive floats are in the order of
// their bits: a histogram of the upper half of the bits leaves few candidates to sort.
float NearerHalf(const cv::Mat& nearness) {
  InterruptionPoint();
  const auto bin_of = [](float value) { return std::bit_cast<std::uint32_t>(value) >> 16; };
  const std::span values(nearness.ptr<float>(), nearness.total());  // continuous, being our own
  std::vector<int> histogram(bin_of(kNoNearness) + 1, 0);
  for (const float value : values) ++histogram[bin_of(value)];
  int below = (static_cast<int>(nearness.total()) - histogram[bin_of(kNoNearness)]) / 2;
  std::uint32_t bin = 0;
  for (; histogram[bin] <= below; ++bin) below -= histogram[bin];

  std::vector<float> candidates;
  candidates.reserve(static_cast<std::size_t>(histogram[bin]));
  for (const float value : values) {
    if (bin_of(value) == bin) candidates.push_back(value);
  }
  std::nth_element(candidates.begin(), candidates.begin() + below, candidates.end());
  return candidates[static_cast<std::size_t>(below)];
}

// Ju's depth prior: × nearness / T below T.
void ApplyDepthPrior(const cv::Mat& nearness, cv::Mat& map) {
  InterruptionPoint();
  const float threshold = NearerHalf(nearness);
  for (int y = 0; y < map.rows; ++y) {
    const float* near = nearness.ptr<float>(y);
    float* to = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) to[x] *= std::min(1.0F, near[x] / threshold);
  }
}

// Ju's centre prior: × exp(−(Δrow/(H/2))² − (Δcolumn/(W/2))²).
void ApplyCenterPrior(cv::Mat& map) {
  InterruptionPoint();
  const auto weight = [](int index, int size) {
    const double offset = (index - (size - 1) / 2.0) / (size / 2.0);
    return static_cast<float>(std::exp(-offset * offset));
  };
  std::vector<float> across;
  across.reserve(static_cast<std::size_t>(map.cols));
  for (int x = 0; x < map.cols; ++x) across.push_back(weight(x, map.cols));
  for (int y = 0; y < map.rows; ++y) {
    const float down = weight(y, map.rows);
    float* row = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) row[x] *= down * across[static_cast<std::size_t>(x)];
  }
}

cv::Mat SaliencyOfPixels(const cv::Mat& depth_m, const DepthSaliencyOptions& options,
                         int line_step_px, const Contrast& contrast) {
  InterruptionPoint();
  const cv::Mat nearness = SmoothNearness(depth_m);
  if (cv::countNonZero(nearness != kNoNearness) == 0) return cv::Mat::zeros(depth_m.size(), CV_32F);

  const double diagonal_px = std::hypot(depth_m.cols, depth_m.rows);
  cv::Mat saliency = contrast(nearness, ScanLines(options.line_length * diagonal_px, line_step_px));
  ScaleToOne(saliency);
  if (options.depth_prior) ApplyDepthPrior(nearness, saliency);
  if (options.center_prior) ApplyCenterPrior(saliency);
  return saliency;
}

}  // namespace

cv::Mat DepthSaliency(const cv::Mat& depth_m, const DepthSaliencyOptions& options,
                      const Contrast& contrast) {
  const int line_step_px = std::max(1, cvRound(double(options.line_step_px) / options.downscale));
  const cv::Mat saliency = SaliencyOfPixels(ReduceDepthByBlocks(depth_m, options.downscale),
                                            options, line_step_px, contrast);
  return EnlargeBlocks(saliency, options.downscale, depth_m.size());
}

}  // namespace fovea
