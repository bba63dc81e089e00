#include "core/segmentation/kinship.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

// Beyond these an angle or a difference of colour says hardly more.
constexpr double kUnevennessDeg = 25;
constexpr double kColorScale = 12;  // CIELAB units
constexpr double kMinHeight_m = 0.05;
constexpr double kMaxDistance_m = 3;  // of the scenes of the fit

constexpr double kBias = -4.374;
constexpr KinshipTerms kWeights = {-9.501, 5.959, -5.437, 6.654, -2.201, 1.308};

}  // namespace

Kinship KinshipOf(const Boundary& boundary, const Part& a, const Part& b) {
  const double bend_deg = std::abs(boundary.convexity_sum_deg) / boundary.num_pairs;
  const double step_deg = boundary.step_sum_deg / boundary.num_pairs;
  Part both = a;
  both.Add(b);
  const double height_m = both.top_m - both.bottom_m;
  return {
      .unevenness = 1 - std::exp(-(bend_deg + step_deg) / kUnevennessDeg),
      .color_likeness = std::exp(-a.color.DistanceTo(b.color) / kColorScale),
      .top_step = std::abs(a.top_m - b.top_m) / std::max(kMinHeight_m, height_m),
      .height_m = height_m,
      .log_area = std::log(both.area_m2),
      .distance_m = std::min(both.z_sum_m / both.num_voxels, kMaxDistance_m),
  };
}

KinshipTerms TermsOf(const Kinship& k) {
  return {k.unevenness, k.color_likeness, k.top_step, k.height_m, k.log_area, k.distance_m};
}

const std::array<std::string_view, kNumKinshipTerms>& KinshipTermNames() {
  static constexpr std::array<std::string_view, kNumKinshipTerms> kNames = {
      "unevenness", "color_likeness", "top_step", "height_m", "log_area", "distance_m"};
  return kNames;
}

double LogOdds(const Kinship& kinship) {
  const KinshipTerms terms = TermsOf(kinship);
  double log_odds = kBias;
  for (std::size_t i = 0; i < terms.size(); ++i) log_odds += kWeights[i] * terms[i];
  return log_odds;
}

}  // namespace fovea
