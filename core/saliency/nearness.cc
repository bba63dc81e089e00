#include "core/saliency/nearness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <tuple>
#include <vector>

#include "core/types/interruption.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

constexpr int kBlurRadius_px = 3;
constexpr double kBlurSigma_px = 1.75;

// Written for loops that the compiler vectorises: no call, no branch.
bool HasDepth(float depth_m) { return (depth_m > 0) & (depth_m < kNoNearness); }

using Kernel = std::array<float, 2 * kBlurRadius_px + 1>;

Kernel GaussianKernel() {
  Kernel kernel;
  for (int i = -kBlurRadius_px; i <= kBlurRadius_px; ++i) {
    kernel[static_cast<std::size_t>(i + kBlurRadius_px)] =
        static_cast<float>(std::exp(-i * i / (2 * kBlurSigma_px * kBlurSigma_px)));
  }
  return kernel;
}

// Of each of the kernel's weights the row that it weighs.
using KernelRows = std::array<const float*, std::tuple_size_v<Kernel>>;

// Sums of what lies at one column of the rows, weighted by the kernel.
FOVEA_INLINE void BlurRow(const KernelRows& from, const Kernel& kernel, int cols, float* to) {
  for (int x = 0; x < cols; ++x) {
    float sum = 0;
    for (std::size_t i = 0; i < kernel.size(); ++i) sum += kernel[i] * from[i][x];
    to[x] = sum;
  }
}

// Along rows, then along columns; what lies outside counts as 0.
FOVEA_INLINE cv::Mat Blur(const cv::Mat& map, const Kernel& kernel) {
  InterruptionPoint();
  // With a margin above and below.
  cv::Mat rows = cv::Mat::zeros(map.rows + 2 * kBlurRadius_px, map.cols, CV_32F);
  std::vector<float> row(static_cast<std::size_t>(map.cols + 2 * kBlurRadius_px));
  KernelRows from;
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = row.data() + i;
  for (int y = 0; y < map.rows; ++y) {
    std::copy_n(map.ptr<float>(y), map.cols, row.begin() + kBlurRadius_px);
    BlurRow(from, kernel, map.cols, rows.ptr<float>(y + kBlurRadius_px));
  }
  cv::Mat blurred(map.size(), CV_32F);
  for (int y = 0; y < map.rows; ++y) {
    for (std::size_t i = 0; i < from.size(); ++i)
      from[i] = rows.ptr<float>(y + static_cast<int>(i));
    BlurRow(from, kernel, map.cols, blurred.ptr<float>(y));
  }
  return blurred;
}

}  // namespace

cv::Mat SmoothNearness(const cv::Mat& depth_m) {
  cv::Mat nearness(depth_m.size(), CV_32F), presence(depth_m.size(), CV_32F);
  for (int y = 0; y < depth_m.rows; ++y) {
    InterruptionPoint();
    const float* depth = depth_m.ptr<float>(y);
    float* near = nearness.ptr<float>(y);
    float* present = presence.ptr<float>(y);
    for (int x = 0; x < depth_m.cols; ++x) {
      const float inverse = 1.0F / depth[x];
      near[x] = HasDepth(depth[x]) ? inverse : 0.0F;
      present[x] = HasDepth(depth[x]) ? 1.0F : 0.0F;
    }
  }
  RunInWidestRegisters([&, kernel = GaussianKernel()] {
    nearness = Blur(nearness, kernel);
    presence = Blur(presence, kernel);
  });
  InterruptionPoint();
  for (int y = 0; y < depth_m.rows; ++y) {
    const float* depth = depth_m.ptr<float>(y);
    const float* present = presence.ptr<float>(y);
    float* near = nearness.ptr<float>(y);
    for (int x = 0; x < depth_m.cols; ++x) {
      const float mean = near[x] / present[x];
      near[x] = HasDepth(depth[x]) ? mean : kNoNearness;
    }
  }
  return nearness;
}

}  // namespace fovea
