// Sixteen strengths of one image row, held in vector registers: the inner step of
// PropagateStrength.
#pragma once

#include <algorithm>
#include <array>

#include "core/types/lanes.h"

namespace fovea {

class StrengthBlock {
 public:
  static constexpr int kSize_px = 16;

  // `features`: values 0 … 255 of the 16 pixels.
  FOVEA_INLINE StrengthBlock(const float* features, const float* strengths)
      : features_{LoadLanes(features), LoadLanes(features + kLanes)},
        strengths_{LoadLanes(strengths), LoadLanes(strengths + kLanes)} {}

  // Eq. 3 and 4 for one neighbour each: strength = max(strength, neighbour's · (1 − |difference| /
  // 255)). The features and strengths are those of the 16 neighbours.
  FOVEA_INLINE void PullFrom(const float* features, const float* strengths) {
    for (std::size_t half = 0; half < 2; ++half, features += kLanes, strengths += kLanes) {
      const Lanes difference = Magnitude(features_[half] - LoadLanes(features));
      const Lanes factor = 1.0F - (difference * kHighPart + difference * kLowPart);
      strengths_[half] = Larger(strengths_[half], LoadLanes(strengths) * factor);
    }
  }

  // Writes back what grew. Returns whether any did.
  FOVEA_INLINE bool Store(float* strengths) {
    std::array<Lanes, 2> grown;
    for (std::size_t half = 0; half < 2; ++half) {
      grown[half] =
          strengths_[half] > LoadLanes(strengths + half * kLanes) ? strengths_[half] : Lanes{};
    }
    if (Largest(grown) == 0) return false;
    for (std::size_t half = 0; half < 2; ++half) {
      grown_[half] = Larger(grown_[half], grown[half]);
      StoreLanes(strengths_[half], strengths + half * kLanes);
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
    StoreLanes(grown_[0], grown.data());
    StoreLanes(grown_[1], grown.data() + kLanes);
    Growth growth{.all = Largest(grown_)};
    for (int i = 0; i < few; ++i) {
      growth.first = std::max(growth.first, grown[i]);
      growth.last = std::max(growth.last, grown[kSize_px - 1 - i]);
    }
    return growth;
  }

 private:
  // 1/255 in two parts: the product of an 8-bit number with the first is exact, so both products
  // together round to the quotient by 255, bit for bit, at a fraction of a division's cost.
  static constexpr float kHighPart = 0x1.01p-8F;
  static constexpr float kLowPart = static_cast<float>(1.0 / 255 - double{kHighPart});

  FOVEA_INLINE static float Largest(const std::array<Lanes, 2>& values) {
    return LargestLane(Larger(values[0], values[1]));
  }

  std::array<Lanes, 2> features_;
  std::array<Lanes, 2> strengths_;
  std::array<Lanes, 2> grown_{};
};

}  // namespace fovea
