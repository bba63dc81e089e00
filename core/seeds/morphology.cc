#include "core/seeds/morphology.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

namespace fovea {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

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

// The minimum over a run of pixels is the smaller of two overlapping power-of-two runs.
void TakeRunMinimum(const float* left_run, const float* right_run, int count, float* to) {
  for (int x = 0; x < count; ++x) {
    const float run = std::min(left_run[x], right_run[x]);
    to[x] = std::min(to[x], run);
  }
}

// Calls visit(y, x) for the neighbours of a pixel that lie in the image.
template <typename Visit>
void ForEachNeighbour(cv::Size size, cv::Point pixel, Visit visit) {
  const int first_x = std::max(pixel.x - 1, 0);
  const int last_x = std::min(pixel.x + 1, size.width - 1);
  const int last_y = std::min(pixel.y + 1, size.height - 1);
  for (int y = std::max(pixel.y - 1, 0); y <= last_y; ++y) {
    for (int x = first_x; x <= last_x; ++x) {
      if (x != pixel.x || y != pixel.y) visit(y, x);
    }
  }
}

// One sweep of Vincent's reconstruction: raises row `to` from the adjacent row `from` (null at the
// image's edge), then along itself in the direction of `step`.
void RaiseRow(const float* from, const float* mask, int cols, int step, float* to) {
  if (from != nullptr) {
    for (int x = 0; x < cols; ++x) {
      const float left = from[std::max(x - 1, 0)];
      const float right = from[std::min(x + 1, cols - 1)];
      const float highest = std::max(std::max(left, right), from[x]);
      to[x] = std::min(std::max(to[x], highest), mask[x]);
    }
  }
  const int first = step > 0 ? 0 : cols - 1;
  float before = to[first];
  for (int turn = 0, x = first; turn < cols; ++turn, x += step) {
    before = std::min(std::max(to[x], before), mask[x]);
    to[x] = before;
  }
}

bool CanRaiseANeighbour(const cv::Mat& map, const cv::Mat& mask, cv::Point pixel) {
  const float value = map.at<float>(pixel);
  bool can = false;
  ForEachNeighbour(map.size(), pixel, [&](int y, int x) {
    const float neighbour = map.at<float>(y, x);
    can |= neighbour < value && neighbour < mask.at<float>(y, x);
  });
  return can;
}

// Raises what the two sweeps left, from pixel to pixel.
void RaiseFrom(std::deque<cv::Point> queue, const cv::Mat& mask, cv::Mat& map) {
  for (; !queue.empty(); queue.pop_front()) {
    const float value = map.at<float>(queue.front());
    ForEachNeighbour(map.size(), queue.front(), [&](int y, int x) {
      float& neighbour = map.at<float>(y, x);
      const float limit = mask.at<float>(y, x);
      if (neighbour < value && neighbour < limit) {
        neighbour = std::min(value, limit);
        queue.emplace_back(x, y);
      }
    });
  }
}

}  // namespace

cv::Mat ErodeByDisk(const cv::Mat& map, int radius_px) {
  cv::Mat padded;
  cv::copyMakeBorder(map, padded, 0, 0, radius_px, radius_px, cv::BORDER_CONSTANT,
                     cv::Scalar::all(kNothing));
  const std::vector<cv::Mat> minima = RowMinima(padded, 2 * radius_px + 1);

  cv::Mat eroded(map.size(), CV_32F, cv::Scalar::all(kNothing));
  for (int y = 0; y < map.rows; ++y) {
    const int last = std::min(y + radius_px, map.rows - 1);
    for (int from = std::max(y - radius_px, 0); from <= last; ++from) {
      const int rise = from - y;
      const int half = static_cast<int>(std::sqrt(radius_px * radius_px - rise * rise));
      const int level = static_cast<int>(std::log2(2 * half + 1));
      const float* runs = minima[static_cast<std::size_t>(level)].ptr<float>(from) + radius_px;
      TakeRunMinimum(runs - half, runs + half + 1 - (1 << level), map.cols, eroded.ptr<float>(y));
    }
  }
  return eroded;
}

cv::Mat ReconstructByDilation(const cv::Mat& marker, const cv::Mat& mask) {
  cv::Mat map = cv::min(marker, mask);
  const int rows = map.rows;
  for (int y = 0; y < rows; ++y) {
    const float* above = y > 0 ? map.ptr<float>(y - 1) : nullptr;
    RaiseRow(above, mask.ptr<float>(y), map.cols, +1, map.ptr<float>(y));
  }
  std::deque<cv::Point> queue;
  for (int y = rows - 1; y >= 0; --y) {
    const float* below = y + 1 < rows ? map.ptr<float>(y + 1) : nullptr;
    RaiseRow(below, mask.ptr<float>(y), map.cols, -1, map.ptr<float>(y));
  }
  for (int y = rows - 1; y >= 0; --y) {
    for (int x = map.cols - 1; x >= 0; --x) {
      if (CanRaiseANeighbour(map, mask, {x, y})) queue.emplace_back(x, y);
    }
  }
  RaiseFrom(std::move(queue), mask, map);
  return map;
}

cv::Mat LabelRegionalMaxima(const cv::Mat& map) {
  constexpr int kRejected = -1;
  cv::Mat labels = cv::Mat::zeros(map.size(), CV_32S);
  int count = 0;
  std::vector<cv::Point> plateau;
  for (int row = 0; row < map.rows; ++row) {
    for (int col = 0; col < map.cols; ++col) {
      if (labels.at<int>(row, col) != 0) continue;
      const float value = map.at<float>(row, col);
      bool is_maximum = true;
      plateau.assign(1, {col, row});
      labels.at<int>(row, col) = kRejected;
      for (std::size_t next = 0; next < plateau.size(); ++next) {
        ForEachNeighbour(map.size(), cv::Point(plateau[next]), [&](int y, int x) {
          const float neighbour = map.at<float>(y, x);
          if (neighbour > value) is_maximum = false;
          if (neighbour != value || labels.at<int>(y, x) != 0) return;
          labels.at<int>(y, x) = kRejected;
          plateau.emplace_back(x, y);
        });
      }
      if (!is_maximum || plateau.size() == map.total()) continue;
      ++count;
      for (const cv::Point& pixel : plateau) labels.at<int>(pixel) = count;
    }
  }
  labels.setTo(0, labels == kRejected);
  return labels;
}

}  // namespace fovea
