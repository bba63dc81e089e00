#include "core/types/squares.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "core/types/widest_registers.h"

namespace fovea {
namespace {

struct Largest {
  template <typename Value>
  static FOVEA_INLINE Value Of(Value a, Value b) {
    return a > b ? a : b;
  }
};
struct Least {
  template <typename Value>
  static FOVEA_INLINE Value Of(Value a, Value b) {
    return a < b ? a : b;
  }
};

// to[i] = Of(to[i], from[i])
template <typename Choice, typename Value>
FOVEA_INLINE void Take(const Value* from, int count, Value* to) {
  for (int i = 0; i < count; ++i) to[i] = Choice::Of(to[i], from[i]);
}

// Along rows into `between`, then along columns back.
template <typename Choice, typename Value>
FOVEA_INLINE void TakeAlongBoth(int reach_px, cv::Mat& image, std::vector<Value>& between) {
  const auto row_between = [&](int y) { return between.data() + std::ptrdiff_t{y} * image.cols; };
  for (int y = 0; y < image.rows; ++y) {
    const Value* from = image.ptr<Value>(y);
    Value* to = row_between(y);
    std::copy_n(from, image.cols, to);
    for (int step = 1; step <= reach_px; ++step) {
      Take<Choice>(from + step, image.cols - step, to);
      Take<Choice>(from, image.cols - step, to + step);
    }
  }
  for (int y = 0; y < image.rows; ++y) {
    Value* to = image.ptr<Value>(y);
    std::copy_n(row_between(y), image.cols, to);
    const int first = std::max(y - reach_px, 0), last = std::min(y + reach_px, image.rows - 1);
    for (int other = first; other <= last; ++other) {
      Take<Choice>(row_between(other), image.cols, to);
    }
  }
}

template <typename Choice, typename Value>
void TakeOf(int reach_px, cv::Mat& image) {
  std::vector<Value> between(image.total());
  RunInWidestRegisters([&] { TakeAlongBoth<Choice>(reach_px, image, between); });
}

template <typename Choice>
void TakeAround(int reach_px, cv::Mat& image) {
  if (image.type() == CV_16UC1) return TakeOf<Choice, std::uint16_t>(reach_px, image);
  CV_Assert(image.type() == CV_8UC1);
  TakeOf<Choice, std::uint8_t>(reach_px, image);
}

}  // namespace

void TakeLargestAround(int reach_px, cv::Mat& image) { TakeAround<Largest>(reach_px, image); }

void TakeLeastAround(int reach_px, cv::Mat& image) { TakeAround<Least>(reach_px, image); }

void CloseGaps(int reach_px, cv::Mat& image) {
  TakeLargestAround(reach_px, image);
  TakeLeastAround(reach_px, image);
}

}  // namespace fovea
