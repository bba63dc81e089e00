#include <algorithm>
#include <array>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <span>
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

// Keeps what is lower than the limits, and the lowest number elsewhere.
FOVEA_INLINE void KeepLower(const float* row, const float* limits, int cols, float* lower) {
  for (int x = 0; x < cols; ++x) {
    lower[x] = row[x] < limits[x] ? row[x] : std::numeric_limits<float>::lowest();
  }
}

// The pixels with no higher neighbour (`highest`, as of HighestNeighbours) beside one as high that
// has one: there their plateau goes on, and is no peak.
class Onward {
 public:
  Onward(const cv::Mat& map, const cv::Mat& highest)
      : map_(map), highest_(highest), marks_(static_cast<std::size_t>(map.cols)) {
    for (std::vector<float>& lower : lower_) lower.resize(marks_.size());
    beside_.resize(marks_.size());
    Enter(0);
    Enter(std::min(1, map.rows - 1));
  }

  // Rows in turn, from the first on. One mark a pixel; empty where there is none.
  std::span<const int> MarksOf(int y) {
    InterruptionPoint();
    int any = 0;
    RunInWidestRegisters([&] {
      if (y > 0 && y + 1 < map_.rows) Enter(y + 1);
      HighestBeside(LowerOf(std::max(y - 1, 0)), LowerOf(y),
                    LowerOf(std::min(y + 1, map_.rows - 1)), map_.cols, beside_.data());
      any = Mark(map_.ptr<float>(y), highest_.ptr<float>(y), beside_.data(), map_.cols,
                 marks_.data());
    });
    return any != 0 ? std::span<const int>(marks_) : std::span<const int>();
  }

 private:
  static FOVEA_INLINE int Mark(const float* row, const float* limits, const float* beside, int cols,
                               int* marks) {
    int any = 0;
    for (int x = 0; x < cols; ++x) {
      marks[x] = ((row[x] >= limits[x]) & (beside[x] == row[x])) ? 1 : 0;
      any |= marks[x];
    }
    return any;
  }
  FOVEA_INLINE void Enter(int y) {
    KeepLower(map_.ptr<float>(y), highest_.ptr<float>(y), map_.cols, LowerOf(y));
  }
  float* LowerOf(int y) { return lower_[static_cast<std::size_t>(y) % lower_.size()].data(); }

  const cv::Mat& map_;
  const cv::Mat& highest_;
  std::array<std::vector<float>, 3> lower_;  // of the row, and of those above and below
  std::vector<float> beside_;
  std::vector<int> marks_;
};

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
  Onward onward(map, highest);
  for (int y = 0; y < map.rows; ++y) {
    const std::span<const int> marks = onward.MarksOf(y);
    const int* row = labels.ptr<int>(y);
    for (std::size_t x = 0; x < marks.size(); ++x) {
      if (marks[x] != 0) keep[static_cast<std::size_t>(row[x])] = 0;
    }
  }
  Renumber(keep, labels);
  return labels;
}

}  // namespace fovea
