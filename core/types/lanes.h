// Eight floats side by side, in the widest registers that the machine has. Each lane computes what
// a float on its own would, so the answer has the same bits in registers of any width.
#pragma once

#include <cstddef>
#include <cstring>

// Code on lanes is inlined into a function that may be compiled for wider registers than the rest
// of the program. Its source files need -Wno-psabi: how lanes are passed does not matter then.
#define FOVEA_INLINE __attribute__((always_inline)) inline

namespace fovea {

constexpr int kLanes = 8;
using Lanes __attribute__((vector_size(kLanes * sizeof(float)))) = float;

FOVEA_INLINE Lanes LoadLanes(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

FOVEA_INLINE Lanes LoadLanes(const float* from, std::ptrdiff_t step) {
  if (step == 1) return LoadLanes(from);
  return Lanes{from[0],        from[step],     from[2 * step], from[3 * step],
               from[4 * step], from[5 * step], from[6 * step], from[7 * step]};
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

#ifdef __x86_64__
template <typename Function>
__attribute__((target("avx2"), flatten)) void RunWithAvx2(const Function& function) {
  function();
}
#endif

// Calls the function, compiled once more for wider registers where the machine has those.
template <typename Function>
void RunInWidestRegisters(const Function& function) {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return RunWithAvx2(function);
#endif
  function();
}

}  // namespace fovea
