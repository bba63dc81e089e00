// Rows are raised by the rows beside them, down and up the image in turn, until none can rise: the
// limit is the same in any order. Sweeps look only where something beside has risen since.
#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <utility>

#include "core/seeds/morphology.h"
#include "core/types/interruption.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

constexpr int kPart_px = 64;  // of a row, looked at together

// The pixels first … end - 1 of a row of `cols`.
struct Part {
  int first = 0, end = 0, cols = 0;
};

// Raises part of row `to` from the adjacent row `from`. Returns whether it rose.
FOVEA_INLINE bool RaiseFrom(const int* from, const int* mask, const Part& part, int* to) {
  int rose = 0;
  const auto raise = [&](int x, int left, int right) {
    const int highest = std::max(std::max(from[left], from[right]), from[x]);
    const int raised = std::min(std::max(to[x], highest), mask[x]);
    rose |= raised ^ to[x];
    to[x] = raised;
  };
  const int last = part.cols - 1;
  if (part.first == 0) raise(0, 0, std::min(1, last));
  for (int x = std::max(part.first, 1); x < std::min(part.end, last); ++x) raise(x, x - 1, x + 1);
  if (part.end > last) raise(last, std::max(last - 1, 0), last);
  return rose != 0;
}

// Raises part of a row by the pixel `kStep` (±1) before each, in this direction. Returns whether it
// rose.
template <int kStep>
FOVEA_INLINE bool RaiseAlong(const int* mask, const Part& part, int* row) {
  // The first pixel of a row has none before it.
  const int first = kStep > 0 ? std::max(part.first, 1) : part.first;
  const int end = kStep > 0 ? part.end : std::min(part.end, part.cols - 1);
  int can_rise = 0;
  for (int x = first; x < end; ++x) can_rise |= std::min(row[x - kStep], mask[x]) > row[x];
  if (can_rise == 0) return false;
  int x = kStep > 0 ? first : end - 1;
  for (int before = row[x - kStep]; first <= x && x < end; x += kStep) {
    row[x] = before = std::min(std::max(row[x], before), mask[x]);
  }
  return true;
}

class Reconstruction {
 public:
  Reconstruction(const cv::Mat& mask, cv::Mat& map)
      : mask_(BitsOf(mask)),
        map_(BitsOf(map)),
        parts_((map.cols + kPart_px - 1) / kPart_px),
        down_(map.rows + 2, parts_ + 2, 1),
        up_(down_.clone()) {}

  FOVEA_INLINE void Run() {
    for (bool rose = true; rose;) {
      rose = false;
      for (int y = 0; y < map_.rows; ++y) rose |= RaiseRow<+1>(y, down_, up_);
      for (int y = map_.rows - 1; y >= 0; --y) rose |= RaiseRow<-1>(y, up_, down_);
    }
  }

 private:
  // Of the parts of each row whether a sweep has to look at them, with a margin of one on all
  // sides.
  using Pending = cv::Mat_<std::uint8_t>;

  // Of floats that are not negative the bits are in the same order, and integers are compared in
  // less time, which counts along a row, from pixel to pixel.
  static cv::Mat BitsOf(const cv::Mat& floats) {
    return {floats.rows, floats.cols, CV_32S, floats.data, floats.step};
  }

  // By the row before it in the direction of the sweep, and along itself.
  template <int kStep>
  FOVEA_INLINE bool RaiseRow(int y, Pending& pending, Pending& pending_back) {
    bool rose = false;
    std::uint8_t* here = &pending(y + 1, 1);
    for (int i = 0; i < parts_; ++i) {
      const int at = kStep > 0 ? i : parts_ - 1 - i;
      if (std::exchange(here[at], 0) == 0 || !RaisePart<kStep>(y, at)) continue;
      rose = true;
      here[at + kStep] = 1;
      pending_back(y + 1, at + 1) = pending_back(y + 1, at + 1 - kStep) = 1;
      for (int beside = at; beside <= at + 2; ++beside) {
        pending(y + 1 + kStep, beside) = pending_back(y + 1 - kStep, beside) = 1;
      }
    }
    if (rose) InterruptionPoint();
    return rose;
  }

  template <int kStep>
  FOVEA_INLINE bool RaisePart(int y, int at) {
    const Part part{at * kPart_px, std::min((at + 1) * kPart_px, map_.cols), map_.cols};
    const int* mask = mask_.ptr<int>(y);
    int* row = map_.ptr<int>(y);
    const int before = y - kStep;
    const bool inside = before >= 0 && before < map_.rows;
    const bool rose = inside && RaiseFrom(map_.ptr<int>(before), mask, part, row);
    return RaiseAlong<kStep>(mask, part, row) || rose;
  }

  cv::Mat mask_, map_;
  int parts_;  // of a row
  Pending down_, up_;
};

}  // namespace

cv::Mat ReconstructByDilation(const cv::Mat& marker, const cv::Mat& mask) {
  cv::Mat map = cv::min(marker, mask);
  Reconstruction reconstruction(mask, map);
  RunInWidestRegisters([&] { reconstruction.Run(); });
  return map;
}

}  // namespace fovea
