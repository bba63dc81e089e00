// What one number of the evidence says, in models that add up such functions.
#pragma once

#include <array>
#include <cstddef>

namespace fovea {

// A straight line through 0 whose slope changes at knots.
struct TermFunction {
  static constexpr std::size_t kNumKnots = 5;
  static constexpr double kNoKnot = 1e9;
  std::array<double, kNumKnots> knots{kNoKnot, kNoKnot, kNoKnot, kNoKnot, kNoKnot};
  std::array<double, kNumKnots + 1> slopes{};  // the first, and what each knot adds to it

  double Of(double term) const;
};

}  // namespace fovea
