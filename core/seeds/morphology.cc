#include "core/seeds/morphology.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
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

// A step of Vincent's sweeps: raises row `to` from the adjacent row `from` (null at the
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

// Raises what the two sweeps left, from pixel to pixel.
void RaiseRest(const cv::Mat& mask, cv::Mat& map) {
  cv::Mat highest;
  cv::dilate(map, highest, cv::Mat());
  std::deque<cv::Point> grown;
  for (int y = 0; y < map.rows; ++y) {
    float* values = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) {
      const float raised = std::min(highest.at<float>(y, x), mask.at<float>(y, x));
      if (raised <= values[x]) continue;
      values[x] = raised;
      grown.emplace_back(x, y);
    }
  }
  for (; !grown.empty(); grown.pop_front()) {
    const float value = map.at<float>(grown.front());
    ForEachNeighbour(map.size(), grown.front(), [&](int y, int x) {
      const float raised = std::min(value, mask.at<float>(y, x));
      if (raised <= map.at<float>(y, x)) return;
      map.at<float>(y, x) = raised;
      grown.emplace_back(x, y);
    });
  }
}

// Numbers the components anew, 1 … n by their first pixels, without those that are not kept.
void Renumber(const std::vector<char>& keep, cv::Mat& labels) {
  std::vector<int> numbers(keep.size(), 0);
  int count = 0;
  for (int& label : cv::Mat_<int>(labels)) {
    const auto component = static_cast<std::size_t>(label);
    if (keep[component] != 0 && numbers[component] == 0) numbers[component] = ++count;
    label = numbers[component];
  }
}

}  // namespace

cv::Mat ErodeByDisk(const cv::Mat& map, int radius_px) {
  cv::Mat padded;
  cv::copyMakeBorder(map, padded, 0, 0, radius_px, radius_px, cv::BORDER_CONSTANT,
                     cv::Scalar::all(kNothing));
  const std::vector<cv::Mat> minima = RowMinima(padded, 2 * radius_px + 1);
  const std::vector<DiskRow> disk = DiskRows(radius_px);

  cv::Mat eroded(map.size(), CV_32F, cv::Scalar::all(kNothing));
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

cv::Mat ReconstructByDilation(const cv::Mat& marker, const cv::Mat& mask) {
  cv::Mat map = cv::min(marker, mask);
  const int rows = map.rows;
  for (int y = 0; y < rows; ++y) {
    const float* above = y > 0 ? map.ptr<float>(y - 1) : nullptr;
    RaiseRow(above, mask.ptr<float>(y), map.cols, +1, map.ptr<float>(y));
  }
  for (int y = rows - 1; y >= 0; --y) {
    const float* below = y + 1 < rows ? map.ptr<float>(y + 1) : nullptr;
    RaiseRow(below, mask.ptr<float>(y), map.cols, -1, map.ptr<float>(y));
  }
  RaiseRest(mask, map);
  return map;
}

cv::Mat LabelRegionalMaxima(const cv::Mat& map) {
  // Pixels with no higher neighbour; neighbours among them are equal, so that a component is a
  // plateau, or a part of one whose other pixels have a higher neighbour.
  cv::Mat highest, labels;
  cv::dilate(map, highest, cv::Mat());
  const cv::Mat candidates = map == highest;
  const int components = cv::connectedComponents(candidates, labels, 8, CV_32S);
  std::vector<char> keep(static_cast<std::size_t>(components), 1);
  keep[0] = 0;  // the rest of the map
  if (cv::countNonZero(candidates) == static_cast<int>(map.total())) {
    return cv::Mat::zeros(map.size(), CV_32S);  // constant
  }

  cv::Mat rest = map.clone();
  rest.setTo(-kNothing, candidates);
  cv::dilate(rest, highest, cv::Mat());
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      const bool goes_on = highest.at<float>(y, x) == map.at<float>(y, x);
      if (goes_on) keep[static_cast<std::size_t>(labels.at<int>(y, x))] = 0;
    }
  }
  Renumber(keep, labels);
  return labels;
}

}  // namespace fovea
