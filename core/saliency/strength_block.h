// Sixteen strengths of one image row, held in vector registers: the inner step of
// PropagateStrength. All is inlined into a caller that may be compiled for wider registers than the
// rest of the program; the arithmetic, and so every bit of the answer, is the same in any.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#define FOVEA_INLINE __attribute__((always_inline)) inline

namespace fovea {

class StrengthBlock {
 public:
  static constexpr int kSize_px = 16;

  // `features`: values 0 … 255 of the 16 pixels.
  FOVEA_INLINE StrengthBlock(const float* features, const float* strengths)
      : features_{Load(features), Load(features + kLanes)},
        strengths_{Load(strengths), Load(strengths + kLanes)} {}

  // Eq. 3 and 4 for one neighbour each: strength = max(strength, neighbour's · (1 − |difference| /
  // 255)). The features and strengths are those of the 16 neighbours.
  FOVEA_INLINE void PullFrom(const float* features, const float* strengths) {
    for (int half = 0; half < 2; ++half, features += kLanes, strengths += kLanes) {
      Lanes difference = features_[half] - Load(features);
      difference = Larger(difference, -difference);
      const Lanes factor = 1.0F - (difference * kHighPart + difference * kLowPart);
      strengths_[half] = Larger(strengths_[half], Load(strengths) * factor);
    }
  }

  // Writes back what grew. Returns whether any did.
  FOVEA_INLINE bool Store(float* strengths) {
    std::array<Lanes, 2> grown;
    for (int half = 0; half < 2; ++half) {
      grown[half] =
          strengths_[half] > Load(strengths + half * kLanes) ? strengths_[half] : Lanes{};
    }
    if (Largest(grown) == 0) return false;
    for (int half = 0; half < 2; ++half) {
      grown_[half] = Larger(grown_[half], grown[half]);
      std::memcpy(strengths + half * kLanes, &strengths_[half], sizeof(Lanes));
    }
    return true;
  }

  // The largest strength among those that have grown (0: none has), over all pixels, the first few
  // and the last few.
  struct Growth {
    float all = 0, first = 0, last = 0;
  };
  FOVEA_INLINE Growth GrowthSoFar(int few) const {
    std::array<float, kSize_px> grown;
    std::memcpy(grown.data(), grown_.data(), sizeof grown);
    Growth growth{.all = Largest(grown_)};
    for (int i = 0; i < few; ++i) {
      growth.first = std::max(growth.first, grown[i]);
      growth.last = std::max(growth.last, grown[kSize_px - 1 - i]);
    }
    return growth;
  }

 private:
  static constexpr int kLanes = 8;
  using Lanes __attribute__((vector_size(kLanes * sizeof(float)))) = float;

  // 1/255 in two parts: the product of an 8-bit number with the first is exact, so both products
  // together round to the quotient by 255, bit for bit, at a fraction of a division's cost.
  static constexpr float kHighPart = 0x1.01p-8F;
  static constexpr float kLowPart = static_cast<float>(1.0 / 255 - double{kHighPart});

  FOVEA_INLINE static Lanes Load(const float* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
  }
  FOVEA_INLINE static Lanes Larger(const Lanes& a, const Lanes& b) { return a > b ? a : b; }
  FOVEA_INLINE static float Largest(const std::array<Lanes, 2>& values) {
    Lanes most = Larger(values[0], values[1]);
    most = Larger(most, __builtin_shufflevector(most, most, 4, 5, 6, 7, 0, 1, 2, 3));
    most = Larger(most, __builtin_shufflevector(most, most, 2, 3, 0, 1, 6, 7, 4, 5));
    return std::max(most[0], most[1]);
  }

  std::array<Lanes, 2> features_;
  std::array<Lanes, 2> strengths_;
  std::array<Lanes, 2> grown_{};
};

}  // namespace fovea
