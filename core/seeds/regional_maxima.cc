#include <algorithm>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/seeds/morphology.h"
#include "core/types/interruption.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

// Of each pixel of a row the highest neighbour; at the image's edge the pixel itself may be it.
FOVEA_INLINE void HighestBeside(const float* above, const float* row, const float* below, int cols,
                                float* highest) {
  const auto find = [=](int x, int left, int right) {
    const float over = std::max(std::max(above[left], above[right]), above[x]);
    const float under = std::max(std::max(below[left], below[right]), below[x]);
    highest[x] = std::max(std::max(over, under), std::max(row[left], row[right]));
  };
  find(0, 0, std::min(1, cols - 1));
  for (int x = 1; x < cols - 1; ++x) find(x, x - 1, x + 1);
  find(cols - 1, std::max(cols - 2, 0), cols - 1);
}

cv::Mat HighestNeighbours(const cv::Mat& map) {
  cv::Mat highest(map.size(), CV_32F);
  RunInWidestRegisters([&] {
    for (int y = 0; y < map.rows; ++y) {
      InterruptionPoint();
      HighestBeside(map.ptr<float>(std::max(y - 1, 0)), map.ptr<float>(y),
                    map.ptr<float>(std::min(y + 1, map.rows - 1)), map.cols, highest.ptr<float>(y));
    }
  });
  return highest;
}

// Keeps what is lower than the other map, and the lowest number elsewhere.
cv::Mat Lower(const cv::Mat& map, const cv::Mat& other) {
  cv::Mat lower(map.size(), CV_32F);
  RunInWidestRegisters([&] {
    for (int y = 0; y < map.rows; ++y) {
      InterruptionPoint();
      const float* from = map.ptr<float>(y);
      const float* limit = other.ptr<float>(y);
      float* to = lower.ptr<float>(y);
      for (int x = 0; x < map.cols; ++x) {
        to[x] = from[x] < limit[x] ? from[x] : std::numeric_limits<float>::lowest();
      }
    }
  });
  return lower;
}

// Numbers the components anew, 1 … n by their first pixels, without those that are not kept.
void Renumber(const std::vector<char>& keep, cv::Mat& labels) {
  InterruptionPoint();
  constexpr int kNotYet = -1;
  std::vector<int> numbers(keep.size());
  std::transform(keep.begin(), keep.end(), numbers.begin(),
                 [](char kept) { return kept != 0 ? kNotYet : 0; });
  int count = 0;
  for (int y = 0; y < labels.rows; ++y) {
    int* row = labels.ptr<int>(y);
    for (int x = 0; x < labels.cols; ++x) {
      int& number = numbers[static_cast<std::size_t>(row[x])];
      if (number == kNotYet) number = ++count;
      row[x] = number;
    }
  }
}

}  // namespace

cv::Mat LabelRegionalMaxima(const cv::Mat& map) {
  // Neighbours among the pixels with no higher neighbour are equal, so that a component is a
  // plateau, or a part of one whose other pixels have a higher neighbour.
  const cv::Mat highest = HighestNeighbours(map);
  const cv::Mat unsurpassed = map >= highest;
  if (cv::countNonZero(unsurpassed) == static_cast<int>(map.total())) {
    return cv::Mat::zeros(map.size(), CV_32S);  // constant
  }
  InterruptionPoint();
  cv::Mat labels;
  const int components = cv::connectedComponents(unsurpassed, labels, 8, CV_32S);
  std::vector<char> keep(static_cast<std::size_t>(components), 1);
  keep[0] = 0;  // the rest of the map
  std::vector<cv::Point> goes_on;
  cv::findNonZero((HighestNeighbours(Lower(map, highest)) == map) & unsurpassed, goes_on);
  for (const cv::Point& pixel : goes_on) keep[static_cast<std::size_t>(labels.at<int>(pixel))] = 0;
  Renumber(keep, labels);
  return labels;
}

}  // namespace fovea
