#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "core/seeds/morphology.h"

namespace fovea {
namespace {

constexpr double kOutside = std::numeric_limits<double>::infinity();

// Minima over 1, 2, 4, … pixels to the right of each pixel, up to `widest` of them.
std::vector<cv::Mat> RowMinima(const cv::Mat& map, int widest) {
  std::vector<cv::Mat> minima{map};
  for (int width = 1; 2 * width <= widest; width *= 2) {
    const cv::Mat& half = minima.back();
    cv::Mat whole = half.clone();
    const int last = half.cols - width;
    for (int y = 0; y < half.rows; ++y) {
      const float* from = half.ptr<float>(y);
      float* to = whole.ptr<float>(y);
      for (int x = 0; x < last; ++x) to[x] = std::min(from[x], from[x + width]);
    }
    minima.push_back(whole);
  }
  return minima;
}

// A row of the disk. Its minimum is the smaller of two overlapping runs of 2^level pixels.
struct DiskRow {
  int rise = 0;  // above and below the centre
  int half_width = 0;
  int level = 0;
};

std::vector<DiskRow> DiskRows(int radius_px) {
  std::vector<DiskRow> rows;
  for (int rise = 0; rise <= radius_px; ++rise) {
    const int half_width = static_cast<int>(std::sqrt(radius_px * radius_px - rise * rise));
    const auto width = static_cast<unsigned>(2 * half_width + 1);
    rows.push_back({rise, half_width, static_cast<int>(std::bit_width(width)) - 1});
  }
  return rows;
}

void TakeRunMinimum(const float* left_run, const float* right_run, int count, float* to) {
  for (int x = 0; x < count; ++x) {
    const float run = std::min(left_run[x], right_run[x]);
    to[x] = std::min(to[x], run);
  }
}

}  // namespace

cv::Mat ErodeByDisk(const cv::Mat& map, int radius_px) {
  cv::Mat padded;
  cv::copyMakeBorder(map, padded, 0, 0, radius_px, radius_px, cv::BORDER_CONSTANT,
                     cv::Scalar::all(kOutside));
  const std::vector<cv::Mat> minima = RowMinima(padded, 2 * radius_px + 1);
  const std::vector<DiskRow> disk = DiskRows(radius_px);

  cv::Mat eroded(map.size(), CV_32F, cv::Scalar::all(kOutside));
  for (int y = 0; y < map.rows; ++y) {
    for (const DiskRow& row : disk) {
      for (const int from : {y - row.rise, y + row.rise}) {
        if (from < 0 || from >= map.rows) continue;
        const float* center =
            minima[static_cast<std::size_t>(row.level)].ptr<float>(from) + radius_px;
        const float* left_run = center - row.half_width;
        const float* right_run = center + row.half_width + 1 - (1 << row.level);
        TakeRunMinimum(left_run, right_run, map.cols, eroded.ptr<float>(y));
      }
    }
  }
  return eroded;
}

}  // namespace fovea
