// Sixteen strengths of one image row, held in SIMD registers: the inner step of PropagateStrength.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/core/hal/intrin.hpp>

namespace fovea {

class StrengthBlock {
 public:
  static constexpr int kSize_px = 16;  // one register of 8-bit features

  StrengthBlock(const std::uint8_t* features, const float* strengths)
      : features_(cv::v_load(features)) {
    for (std::size_t i = 0; i < 4; ++i) strengths_[i] = cv::v_load(strengths + 4 * i);
  }

  // Eq. 3 and 4 for one neighbour each: strength = max(strength, neighbour's · (1 − |difference| /
  // 255)). The features and strengths are those of the 16 neighbours.
  void PullFrom(const std::uint8_t* features, const float* strengths) {
    cv::v_uint16x8 low, high;
    cv::v_expand(cv::v_absdiff(features_, cv::v_load(features)), low, high);
    std::array<cv::v_uint32x4, 4> differences;
    cv::v_expand(low, differences[0], differences[1]);
    cv::v_expand(high, differences[2], differences[3]);
    const cv::v_float32x4 one = cv::v_setall_f32(1.0F);
    const cv::v_float32x4 high_part = cv::v_setall_f32(kHighPart);
    const cv::v_float32x4 low_part = cv::v_setall_f32(kLowPart);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto difference = cv::v_cvt_f32(cv::v_reinterpret_as_s32(differences[i]));
      const auto factor = one - (difference * high_part + difference * low_part);
      strengths_[i] = cv::v_max(strengths_[i], cv::v_load(strengths + 4 * i) * factor);
    }
  }

  // Writes back what grew. Bit i of the answer: pixel i did.
  unsigned Store(float* strengths) const {
    unsigned grown = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto mask = strengths_[i] > cv::v_load(strengths + 4 * i);
      grown |= static_cast<unsigned>(cv::v_signmask(mask)) << (4 * i);
    }
    if (grown == 0) return 0;
    for (std::size_t i = 0; i < 4; ++i) cv::v_store(strengths + 4 * i, strengths_[i]);
    return grown;
  }

 private:
  // 1/255 in two parts: the product of an 8-bit number with the first is exact, so both products
  // together round to the quotient by 255, bit for bit, at a fraction of a division's cost.
  static constexpr float kHighPart = 0x1.01p-8F;
  static constexpr float kLowPart = static_cast<float>(1.0 / 255 - double{kHighPart});

  cv::v_uint8x16 features_;
  std::array<cv::v_float32x4, 4> strengths_;
};

}  // namespace fovea
