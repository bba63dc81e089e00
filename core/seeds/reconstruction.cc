#include <algorithm>
#include <deque>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/seeds/morphology.h"

namespace fovea {
namespace {

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

// Raises row `to` from the adjacent row `from`.
void RaiseFrom(const float* from, const float* mask, int cols, float* to) {
  const auto raise = [=](int x, int left, int right) {
    const float highest = std::max(std::max(from[left], from[right]), from[x]);
    to[x] = std::min(std::max(to[x], highest), mask[x]);
  };
  raise(0, 0, std::min(1, cols - 1));
  for (int x = 1; x < cols - 1; ++x) raise(x, x - 1, x + 1);
  raise(cols - 1, std::max(cols - 2, 0), cols - 1);
}

// A step of Vincent's sweeps: raises row `to` from the adjacent row `from` (null at the
// image's edge), then along itself in the direction of `step`.
void RaiseRow(const float* from, const float* mask, int cols, int step, float* to) {
  if (from != nullptr) RaiseFrom(from, mask, cols, to);
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
    const float* around = highest.ptr<float>(y);
    const float* limits = mask.ptr<float>(y);
    float* values = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) {
      const float raised = std::min(around[x], limits[x]);
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

}  // namespace

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

}  // namespace fovea
