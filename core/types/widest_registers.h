// Loops compiled for wider vector registers than the rest of the program, where the machine has
// them. No operation on floats is contracted or reordered, so the answer has the same bits either
// way.
#pragma once

// Code to be compiled for wider registers must be inlined into the function that is.
#define FOVEA_INLINE __attribute__((always_inline)) inline

namespace fovea {

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
