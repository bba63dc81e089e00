#include "core/saliency/nearness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>

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

// Sums of the rows about each row, weighted by the kernel; what lies outside counts as 0.
FOVEA_INLINE cv::Mat BlurColumns(const cv::Mat& map, const Kernel& kernel) {
  InterruptionPoint();
  cv::Mat blurred = cv::Mat::zeros(map.size(), CV_32F);
  for (int y = 0; y < map.rows; ++y) {
    float* to = blurred.ptr<float>(y);
    const int last = std::min(y + kBlurRadius_px, map.rows - 1);
    for (int from_y = std::max(y - kBlurRadius_px, 0); from_y <= last; ++from_y) {
      const float weight = kernel[static_cast<std::size_t>(from_y - y + kBlurRadius_px)];
      const float* from = map.ptr<float>(from_y);
      for (int x = 0; x < map.cols; ++x) to[x] += weight * from[x];
    }
  }
  return blurred;
}

// The same along rows.
FOVEA_INLINE cv::Mat BlurRows(const cv::Mat& map, const Kernel& kernel) {
  InterruptionPoint();
  cv::Mat blurred = cv::Mat::zeros(map.size(), CV_32F);
  for (int y = 0; y < map.rows; ++y) {
    const float* from = map.ptr<float>(y);
    float* to = blurred.ptr<float>(y);
    for (int shift = -kBlurRadius_px; shift <= kBlurRadius_px; ++shift) {
      const float weight = kernel[static_cast<std::size_t>(shift + kBlurRadius_px)];
      const int end = std::min(map.cols, map.cols - shift);
      for (int x = std::max(0, -shift); x < end; ++x) to[x] += weight * from[x + shift];
    }
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
    nearness = BlurColumns(BlurRows(nearness, kernel), kernel);
    presence = BlurColumns(BlurRows(presence, kernel), kernel);
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
