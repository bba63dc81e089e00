#include <algorithm>
#include <deque>
#include <opencv2/core.hpp>

#include "core/seeds/morphology.h"
#include "core/seeds/neighbours.h"
#include "core/types/interruption.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

constexpr int kCheckedTogether = 32;  // pixels of a row

// Raises row `to` from the adjacent row `from`.
FOVEA_INLINE void RaiseFrom(const float* from, const float* mask, int cols, float* to) {
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
FOVEA_INLINE void RaiseRow(const float* from, const float* mask, int cols, int step, float* to) {
  if (from != nullptr) RaiseFrom(from, mask, cols, to);
  const int first = step > 0 ? 0 : cols - 1;
  float before = to[first];
  for (int turn = 0, x = first; turn < cols; ++turn, x += step) {
    before = std::min(std::max(to[x], before), mask[x]);
    to[x] = before;
  }
}

// Whether some of the pixels first … end - 1 of a row can still rise by the row above or by the
// pixel on their left; not for the first or last of a row.
FOVEA_INLINE bool CanRise(const float* above, const float* mask, const float* row, int first,
                          int end) {
  int can_rise = 0;
  for (int x = first; x < end; ++x) {
    const float highest =
        std::max(std::max(above[x - 1], above[x]), std::max(above[x + 1], row[x - 1]));
    can_rise |= std::min(highest, mask[x]) > row[x];
  }
  return can_rise != 0;
}

// Raises what the two sweeps left, from pixel to pixel. After the sweep upwards no pixel can rise
// by the row below or by the pixel on its right.
void RaiseRest(const cv::Mat& mask, cv::Mat& map) {
  std::deque<cv::Point> grown;
  const auto raise = [&](int y, int x) {
    float highest = map.at<float>(y, x);
    ForEachNeighbour(map.size(), {x, y}, [&](int other_y, int other_x) {
      highest = std::max(highest, map.at<float>(other_y, other_x));
    });
    const float raised = std::min(highest, mask.at<float>(y, x));
    if (!(raised > map.at<float>(y, x))) return;  // nor is NaN
    map.at<float>(y, x) = raised;
    grown.emplace_back(x, y);
  };
  RunInWidestRegisters([&] {
    for (int y = 0; y < map.rows; ++y) {
      const float* above = map.ptr<float>(std::max(y - 1, 0));
      InterruptionPoint();
      raise(y, 0);
      for (int first = 1; first < map.cols - 1; first += kCheckedTogether) {
        const int end = std::min(first + kCheckedTogether, map.cols - 1);
        if (!CanRise(above, mask.ptr<float>(y), map.ptr<float>(y), first, end)) continue;
        for (int x = first; x < end; ++x) raise(y, x);
      }
      raise(y, map.cols - 1);
    }
  });
  LongLoop loop;
  for (; !grown.empty(); grown.pop_front()) {
    loop.Turn();
    const float value = map.at<float>(grown.front());
    ForEachNeighbour(map.size(), grown.front(), [&](int y, int x) {
      const float raised = std::min(value, mask.at<float>(y, x));
      if (!(raised > map.at<float>(y, x))) return;  // nor is NaN
      map.at<float>(y, x) = raised;
      grown.emplace_back(x, y);
    });
  }
}

}  // namespace

cv::Mat ReconstructByDilation(const cv::Mat& marker, const cv::Mat& mask) {
  cv::Mat map = cv::min(marker, mask);
  const int rows = map.rows;
  RunInWidestRegisters([&] {
    for (int y = 0; y < rows; ++y) {
      InterruptionPoint();
      const float* above = y > 0 ? map.ptr<float>(y - 1) : nullptr;
      RaiseRow(above, mask.ptr<float>(y), map.cols, +1, map.ptr<float>(y));
    }
    for (int y = rows - 1; y >= 0; --y) {
      InterruptionPoint();
      const float* below = y + 1 < rows ? map.ptr<float>(y + 1) : nullptr;
      RaiseRow(below, mask.ptr<float>(y), map.cols, -1, map.ptr<float>(y));
    }
  });
  RaiseRest(mask, map);
  return map;
}

}  // namespace fovea
