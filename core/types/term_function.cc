#include "core/types/term_function.h"

#include <algorithm>

namespace fovea {

double TermFunction::Of(double term) const {
  double value = slopes[0] * term;
  for (std::size_t k = 0; k < kNumKnots; ++k)
    value += slopes[k + 1] * std::max(0.0, term - knots[k]);
  return value;
}

}  // namespace fovea
