#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/seeds/morphology.h"
#include "core/seeds/neighbours.h"
#include "core/types/interruption.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

// Numbers the components anew, 1 … n by their first pixels, without those that are not kept.
void Renumber(const std::vector<char>& keep, cv::Mat& labels) {
  InterruptionPoint();
  std::vector<int> numbers(keep.size(), 0);
  int count = 0;
  for (int y = 0; y < labels.rows; ++y) {
    int* row = labels.ptr<int>(y);
    for (int x = 0; x < labels.cols; ++x) {
      if (row[x] == 0) continue;
      const auto component = static_cast<std::size_t>(row[x]);
      if (keep[component] != 0 && numbers[component] == 0) numbers[component] = ++count;
      row[x] = numbers[component];
    }
  }
}

// 255 where none of a pixel's neighbours is higher, else 0.
FOVEA_INLINE void MarkUnsurpassed(const float* above, const float* row, const float* below,
                                  int cols, std::uint8_t* marks) {
  const auto mark = [=](int x, int left, int right) {
    const float over = std::max(std::max(above[left], above[right]), above[x]);
    const float under = std::max(std::max(below[left], below[right]), below[x]);
    const float beside = std::max(row[left], row[right]);
    marks[x] = row[x] >= std::max(std::max(over, under), beside) ? 255 : 0;
  };
  mark(0, 0, std::min(1, cols - 1));
  for (int x = 1; x < cols - 1; ++x) mark(x, x - 1, x + 1);
  mark(cols - 1, std::max(cols - 2, 0), cols - 1);
}

cv::Mat Unsurpassed(const cv::Mat& map) {
  InterruptionPoint();
  cv::Mat marks(map.size(), CV_8UC1);
  RunInWidestRegisters([&] {
    for (int y = 0; y < map.rows; ++y) {
      MarkUnsurpassed(map.ptr<float>(std::max(y - 1, 0)), map.ptr<float>(y),
                      map.ptr<float>(std::min(y + 1, map.rows - 1)), map.cols,
                      marks.ptr<std::uint8_t>(y));
    }
  });
  return marks;
}

// Whether a plateau goes on beside this pixel of it where it has a higher neighbour.
bool GoesOn(const cv::Mat& map, const cv::Mat& unsurpassed, const cv::Point& pixel) {
  bool goes_on = false;
  ForEachNeighbour(map.size(), pixel, [&](int y, int x) {
    goes_on |=
        unsurpassed.at<std::uint8_t>(y, x) == 0 && map.at<float>(y, x) == map.at<float>(pixel);
  });
  return goes_on;
}

}  // namespace

cv::Mat LabelRegionalMaxima(const cv::Mat& map) {
  // Neighbours among the pixels with no higher neighbour are equal, so that a component is a
  // plateau, or a part of one whose other pixels have a higher neighbour.
  const cv::Mat unsurpassed = Unsurpassed(map);
  InterruptionPoint();
  if (cv::countNonZero(unsurpassed) == static_cast<int>(map.total())) {
    return cv::Mat::zeros(map.size(), CV_32S);  // constant
  }
  cv::Mat labels, surrounded;
  cv::erode(unsurpassed, surrounded, cv::Mat());
  InterruptionPoint();
  const int components = cv::connectedComponents(unsurpassed, labels, 8, CV_32S);
  InterruptionPoint();
  std::vector<char> keep(static_cast<std::size_t>(components), 1);
  keep[0] = 0;  // the rest of the map
  for (int y = 0; y < map.rows; ++y) {
    const int* component = labels.ptr<int>(y);
    InterruptionPoint();
    const auto* inner = surrounded.ptr<std::uint8_t>(y);
    for (int x = 0; x < map.cols; ++x) {
      if (component[x] == 0 || inner[x] != 0) continue;
      char& kept = keep[static_cast<std::size_t>(component[x])];
      if (kept != 0 && GoesOn(map, unsurpassed, {x, y})) kept = 0;
    }
  }
  Renumber(keep, labels);
  return labels;
}

}  // namespace fovea
