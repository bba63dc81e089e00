#include "core/depth/fill_depth_holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "core/types/interruption.h"
#include "core/types/squares.h"

namespace fovea {
namespace {

constexpr int kWindowRadius = 2;
constexpr int kWindowPixels = 25;

struct Neighborhood {
  std::array<float, kWindowPixels> depths;
  int count = 0;
};

Neighborhood MeasuredAround(const cv::Mat& depth, int row, int col) {
  Neighborhood around;
  for (int r = std::max(0, row - kWindowRadius); r <= std::min(depth.rows - 1, row + kWindowRadius);
       ++r) {
    const float* line = depth.ptr<float>(r);
    for (int c = std::max(0, col - kWindowRadius);
         c <= std::min(depth.cols - 1, col + kWindowRadius); ++c) {
      if (!std::isnan(line[c])) around.depths[around.count++] = line[c];
    }
  }
  return around;
}

// Sorts the depths; the window that slides over them is [first, last].
float Mode(Neighborhood& around, float bin) {
  std::sort(around.depths.begin(), around.depths.begin() + around.count);
  int best_first = 0;
  int best_count = 0;
  for (int first = 0, last = 0; first < around.count; ++first) {
    while (last + 1 < around.count && around.depths[last + 1] <= around.depths[first] + bin) ++last;
    if (last - first + 1 >= best_count) {  // ≥: the farthest of equals
      best_first = first;
      best_count = last - first + 1;
    }
  }
  return around.depths[best_first + best_count / 2];
}

cv::Mat FillOnce(const cv::Mat& depth, float bin) {
  const cv::Mat measured = depth == depth;  // false for NaN
  cv::Mat near_measured = measured.clone();
  TakeLargestAround(kWindowRadius, near_measured);
  std::vector<cv::Point> holes;
  cv::findNonZero(near_measured != measured, holes);
  cv::Mat filled = depth.clone();
  LongLoop loop;
  for (const cv::Point& hole : holes) {
    loop.Turn();
    Neighborhood around = MeasuredAround(depth, hole.y, hole.x);
    filled.at<float>(hole) = Mode(around, bin);
  }
  return filled;
}

}  // namespace

cv::Mat FillDepthHoles(const cv::Mat& depth_m, const DepthFillOptions& options) {
  cv::Mat filled = depth_m;
  for (int pass = 0; pass < options.passes; ++pass) {
    filled = FillOnce(filled, static_cast<float>(options.bin_m));
  }
  return filled;
}

}  // namespace fovea
