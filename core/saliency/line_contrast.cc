#include "core/saliency/line_contrast.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

#include "core/saliency/nearness.h"
#include "core/types/interruption.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

// map(p) = min(map(p), map(p + shift)) where p + shift lies in the image; in place, in an order
// that reads every row before it changes. `row`: room for one.
FOVEA_INLINE void TakeShiftedMinimum(cv::Mat& map, cv::Point shift, std::vector<float>& row) {
  InterruptionPoint();
  const int first_x = std::max(0, -shift.x);
  const int count_x = map.cols - std::abs(shift.x);
  const int count_y = map.rows - std::abs(shift.y);
  if (count_x <= 0) return;
  for (int turn = 0; turn < count_y; ++turn) {
    const int y = shift.y >= 0 ? turn : map.rows - 1 - turn;
    const float* from = map.ptr<float>(y + shift.y) + first_x + shift.x;
    float* to = map.ptr<float>(y) + first_x;
    if (shift.y == 0) {
      std::copy_n(from, count_x, row.begin());
      from = row.data();
    }
    for (int x = 0; x < count_x; ++x) to[x] = std::min(to[x], from[x]);
  }
}

// Turns every value into the least along a line from its pixel, itself included. A run of 2n
// samples is two runs of n, and any longer one is two overlapping runs.
FOVEA_INLINE void TakeLineMinima(const ScanLine& line, cv::Mat& map, std::vector<float>& row) {
  const int samples = line.count + 1;
  int covered = 1;
  for (; 2 * covered <= samples; covered *= 2) TakeShiftedMinimum(map, line.step * covered, row);
  if (covered < samples) TakeShiftedMinimum(map, line.step * (samples - covered), row);
}

}  // namespace

std::array<ScanLine, 8> ScanLines(double length_px, int step_px) {
  const int diagonal = std::max(1, static_cast<int>(std::lround(step_px * std::sqrt(0.5))));
  std::array<ScanLine, 8> lines;
  std::size_t next = 0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      if (x == 0 && y == 0) continue;
      const cv::Point step = cv::Point(x, y) * (x == 0 || y == 0 ? step_px : diagonal);
      lines[next++] = {step, static_cast<int>(length_px / std::hypot(step.x, step.y))};
    }
  }
  return lines;
}

cv::Mat ContrastOfPixels(const cv::Mat& nearness, const std::array<ScanLine, 8>& lines) {
  cv::Mat contrast = cv::Mat::zeros(nearness.size(), CV_32F);
  cv::Mat minima;
  std::vector<float> row(static_cast<std::size_t>(nearness.cols));
  for (const ScanLine& line : lines) {
    nearness.copyTo(minima);
    InterruptionPoint();
    RunInWidestRegisters([&] {
      TakeLineMinima(line, minima, row);
      for (int y = 0; y < nearness.rows; ++y) {
        const float* own = nearness.ptr<float>(y);
        const float* least = minima.ptr<float>(y);
        float* sum = contrast.ptr<float>(y);
        for (int x = 0; x < nearness.cols; ++x) sum[x] += own[x] - least[x];
      }
    });
  }
  contrast.setTo(0.0F, nearness == kNoNearness);
  return contrast;
}

}  // namespace fovea
