#include "core/segmentation/kinship.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

// Beyond these an angle or a difference of colour says hardly more.
constexpr double kUnevennessDeg = 25;
constexpr double kColorScale = 12;  // units of core/segmentation/mean_color.h
constexpr double kContrastScale = 6;
constexpr double kFlat_m = 0.025;
constexpr double kMinHeight_m = 0.05;
constexpr double kMaxDistance_m = 3;  // of the scenes of the fit

constexpr double kBias = -7.152;
constexpr KinshipTerms kWeights = {-9.092, 5.042, -6.006,  14.23, -2.507,
                                   1.142,  4.574, 0.02211, 3.911};

}  // namespace

Kinship KinshipOf(const Boundary& boundary, const Part& a, const Part& b) {
  const double convexity_deg = boundary.convexity_sum_deg / boundary.num_pairs;
  const double step_deg = boundary.step_sum_deg / boundary.num_pairs;
  Part both = a;
  both.Add(b);
  const double height_m = both.top_m - both.bottom_m;
  const double lower_m = std::min(a.top_m - a.bottom_m, b.top_m - b.bottom_m);
  const double flatness = std::exp(-lower_m / kFlat_m);
  const double contrast = boundary.contrast_sum / boundary.num_pairs;
  return {
      .unevenness = 1 - std::exp(-(std::abs(convexity_deg) + step_deg) / kUnevennessDeg),
      .color_likeness = std::exp(-a.color.DistanceTo(b.color) / kColorScale),
      .top_step = std::abs(a.top_m - b.top_m) / std::max(kMinHeight_m, height_m),
      .height_m = height_m,
      .log_area = std::log(both.area_m2),
      .distance_m = std::min(both.z_sum_m / both.num_voxels, kMaxDistance_m),
      .flatness = flatness,
      .convexity_deg = convexity_deg * (1 - flatness),
      .color_continuity = std::exp(-contrast / kContrastScale),
  };
}

KinshipTerms TermsOf(const Kinship& k) {
  return {k.unevenness, k.color_likeness, k.top_step,      k.height_m,        k.log_area,
          k.distance_m, k.flatness,       k.convexity_deg, k.color_continuity};
}

const std::array<std::string_view, kNumKinshipTerms>& KinshipTermNames() {
  static constexpr std::array<std::string_view, kNumKinshipTerms> kNames = {
      "unevenness", "color_likeness", "top_step",      "height_m",        "log_area",
      "distance_m", "flatness",       "convexity_deg", "color_continuity"};
  return kNames;
}

double LogOdds(const Kinship& kinship) {
  const KinshipTerms terms = TermsOf(kinship);
  double log_odds = kBias;
  for (std::size_t i = 0; i < terms.size(); ++i) log_odds += kWeights[i] * terms[i];
  return log_odds;
}

}  // namespace fovea
