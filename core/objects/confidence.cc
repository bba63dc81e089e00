#include "core/objects/confidence.h"

#include <algorithm>
#include <cmath>

namespace fovea {

float Confidence(double visible_area_m2, double distance_m) {
  constexpr double kAmpleM2 = 0.005;  // more than this makes no difference
  constexpr double kNearM = 1;        // nor does being nearer
  const double logit = 3.5 + 2.53 * std::min(0.0, std::log(visible_area_m2 / kAmpleM2)) -
                       0.71 * std::max(0.0, distance_m - kNearM);
  return static_cast<float>(1 / (1 + std::exp(-logit)));
}

}  // namespace fovea
