// A mask as runs of pixels along the rows of an image: far fewer than there are pixels, and each of
// them one piece of memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <opencv2/core/types.hpp>
#include <vector>

namespace fovea {

// Pixels first … end - 1 of a row, at least one.
struct PixelRun {
  int row = 0, first = 0, end = 0;
};
using PixelRuns = std::vector<PixelRun>;  // in row-major order

inline std::size_t CountPixels(const PixelRuns& runs) {
  std::size_t count = 0;
  for (const PixelRun& run : runs) count += static_cast<std::size_t>(run.end - run.first);
  return count;
}

// The smallest upright rectangle around them; `runs`: not empty.
inline cv::Rect BoundsOf(const PixelRuns& runs) {
  int first = runs.front().first, end = runs.front().end;
  for (const PixelRun& run : runs) {
    first = std::min(first, run.first);
    end = std::max(end, run.end);
  }
  return {cv::Point(first, runs.front().row), cv::Point(end, runs.back().row + 1)};
}

}  // namespace fovea
