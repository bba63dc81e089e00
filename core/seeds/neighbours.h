// The pixels beside a pixel.
#pragma once

#include <algorithm>
#include <opencv2/core/types.hpp>

namespace fovea {

// Calls visit(y, x) for each of the up to eight neighbours of a pixel that lie in the image.
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

}  // namespace fovea
