#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/seeds/morphology.h"

namespace fovea {
namespace {

// Numbers the components anew, 1 … n by their first pixels, without those that are not kept.
void Renumber(const std::vector<char>& keep, cv::Mat& labels) {
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

}  // namespace

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
  rest.setTo(-std::numeric_limits<double>::infinity(), candidates);
  cv::dilate(rest, highest, cv::Mat());
  for (int y = 0; y < map.rows; ++y) {
    const float* around = highest.ptr<float>(y);
    const float* values = map.ptr<float>(y);
    const int* component = labels.ptr<int>(y);
    for (int x = 0; x < map.cols; ++x) {
      const bool goes_on = component[x] != 0 && around[x] == values[x];
      if (goes_on) keep[static_cast<std::size_t>(component[x])] = 0;
    }
  }
  Renumber(keep, labels);
  return labels;
}

}  // namespace fovea
