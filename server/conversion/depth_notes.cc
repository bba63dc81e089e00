#include "server/conversion/depth_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <opencv2/core.hpp>

namespace fovea::server {
namespace {

// Depth in classes of a tenth of itself: the first bits of a float are its logarithm.
class DepthClasses {
 public:
  explicit DepthClasses(const cv::Mat& depth_m) {
    constexpr int kColumns = 320;  // tell as much as all of a larger image
    const int step = std::max(2, depth_m.cols / kColumns);
    for (int row = 0; row < depth_m.rows; row += step) {
      const float* depth = depth_m.ptr<float>(row);
      for (int col = 0; col < depth_m.cols; col += step) Add(depth[col]);
    }
  }

  // Of what was measured.
  double ShareBelow(double limit_m) const {
    const int end = ClassOf(static_cast<float>(limit_m));
    const std::size_t below = Count(0, end);
    return num_measured_ == 0 ? 0 : static_cast<double>(below) / static_cast<double>(num_measured_);
  }

  float Farthest() const {
    float farthest_m = 0;
    for (const Class& each : classes_) {
      if (each.count > 0) farthest_m = std::max(farthest_m, each.farthest_m);
    }
    return farthest_m;
  }

  // Depth that many pixels have to the last bit and nothing near it: no surface is so flat and so
  // alone.
  struct Lone {
    float depth_m;
    double share;  // of the pixels
  };
  std::optional<Lone> LoneValue() const {
    constexpr int kNear = 4;  // some third of it
    constexpr double kMinShare = 0.01, kMaxNear = 0.02;
    for (int i = 0; i < kNumClasses; ++i) {
      const Class& each = classes_[static_cast<std::size_t>(i)];
      const auto count = static_cast<double>(each.count);
      if (count < kMinShare * static_cast<double>(num_pixels_)) continue;
      if (each.nearest_m != each.farthest_m) continue;
      const auto near = static_cast<double>(Count(i - kNear, i + kNear + 1) - each.count);
      if (near > kMaxNear * count) continue;
      return Lone{each.nearest_m, count / static_cast<double>(num_pixels_)};
    }
    return std::nullopt;
  }

 private:
  struct Class {
    std::size_t count = 0;
    float nearest_m = std::numeric_limits<float>::infinity();
    float farthest_m = 0;
  };
  static constexpr int kDroppedBits = 20;  // eight classes from each power of two to the next
  static constexpr int kNumClasses = 1 << (31 - kDroppedBits);

  static int ClassOf(float depth_m) {
    return static_cast<int>(std::bit_cast<std::uint32_t>(depth_m) >> kDroppedBits);
  }

  void Add(float depth_m) {
    ++num_pixels_;
    if (!(depth_m > 0 && std::isfinite(depth_m))) return;
    ++num_measured_;
    Class& its = classes_[static_cast<std::size_t>(ClassOf(depth_m))];
    ++its.count;
    its.nearest_m = std::min(its.nearest_m, depth_m);
    its.farthest_m = std::max(its.farthest_m, depth_m);
  }

  std::size_t Count(int begin, int end) const {
    return std::accumulate(classes_.begin() + std::max(begin, 0),
                           classes_.begin() + std::min(end, kNumClasses), std::size_t{0},
                           [](std::size_t sum, const Class& each) { return sum + each.count; });
  }

  std::array<Class, kNumClasses> classes_{};
  std::size_t num_pixels_ = 0, num_measured_ = 0;
};

// Of 16 bits whose upper half is not used.
bool IsOf8Bits(float farthest_m, const v1::DepthImage& depth) {
  const bool is_float = depth.encoding() == v1::DEPTH_ENCODING_32FC1 ||
                        depth.encoding() == v1::DEPTH_ENCODING_32FC1_ZSTD;
  const double unit_m = depth.unit_m() == 0 ? 0.001 : depth.unit_m();
  return !is_float && std::lround(farthest_m / unit_m) == 255;
}

}  // namespace

std::optional<std::string> OddDepth(const cv::Mat& depth_m, const v1::DepthImage& depth) {
  constexpr double kNear_m = 0.1, kMaxNear = 0.5, kAll = 0.99;
  const DepthClasses classes(depth_m);
  const double near = classes.ShareBelow(kNear_m);
  // Metres in integers have a few values, all of them alone.
  const auto lone = near > kAll ? std::nullopt : classes.LoneValue();
  if (lone) {
    return fmt::format(
        "{:.0f} % of the pixels have a depth of exactly {:g} m, and hardly any one near it: "
        "if that stands for \"not measured\", send 0 (NaN in float depth) instead",
        lone->share * 100, lone->depth_m);
  }
  if (IsOf8Bits(classes.Farthest(), depth)) {
    return "the largest value of depth is 255, as if it had been a picture of 8 bits: depth must "
           "have 16 bits, in units of frame.depth.unit_m";
  }
  if (near > kMaxNear) {
    return fmt::format(
        "more than half of the measured depth is nearer than {:g} m, where hardly any camera "
        "measures: check the depth unit, and that it is depth, not disparity",
        kNear_m);
  }
  return std::nullopt;
}

}  // namespace fovea::server
