// Eight floats side by side, in the widest registers that the machine has. Each lane computes what
// a float on its own would, so the answer has the same bits in registers of any width. Source files
// that use them need -Wno-psabi: they are only passed to inlined functions, so how does not matter.
#pragma once

#include <cstring>

#include "core/types/widest_registers.h"

namespace fovea {

constexpr int kLanes = 8;
using Lanes __attribute__((vector_size(kLanes * sizeof(float)))) = float;

FOVEA_INLINE Lanes LoadLanes(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

FOVEA_INLINE void StoreLanes(const Lanes& lanes, float* to) {
  std::memcpy(to, &lanes, sizeof lanes);
}

FOVEA_INLINE Lanes AllLanes(float value) { return Lanes{} + value; }
FOVEA_INLINE Lanes Larger(const Lanes& a, const Lanes& b) { return a > b ? a : b; }
FOVEA_INLINE Lanes Magnitude(const Lanes& a) { return Larger(a, -a); }

FOVEA_INLINE float LargestLane(const Lanes& values) {
  Lanes most = Larger(values, __builtin_shufflevector(values, values, 4, 5, 6, 7, 0, 1, 2, 3));
  most = Larger(most, __builtin_shufflevector(most, most, 2, 3, 0, 1, 6, 7, 4, 5));
  return most[0] > most[1] ? most[0] : most[1];
}

}  // namespace fovea
