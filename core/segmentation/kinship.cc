#include "core/segmentation/kinship.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

// Beyond these an angle or a difference of colour says hardly more.
constexpr double kUnevennessDeg = 25;
constexpr double kLikeColors = 12;  // units of core/segmentation/mean_color.h
constexpr double kContrastScale = 6;
constexpr double kFlat_m = 0.025;
constexpr double kMinHeight_m = 0.05;
constexpr double kMinExtent_m = 0.01;
constexpr double kMaxDistance_m = 3;  // of the scenes of the fit

constexpr double kBias = -9.635;
constexpr KinshipTerms kWeights = {-9.23, 21.49,   -12.39, -2.952, -3.658, 1.876,  0.3684, 0.02403,
                                   3.463, -0.2991, -5.428, 6.666,  4.056,  -2.022, 8.127,  4.219};

// What two intervals have in common, and what they take up together.
struct Intervals {
  double common_m = 0;
  double both_m = 0;
  double closer_ends_m = 0;  // of the differences between their ends, the less
};

Intervals Compare(const Part& a, const Part& b, int axis) {
  const double a_min = a.extent.min()[axis], a_max = a.extent.max()[axis];
  const double b_min = b.extent.min()[axis], b_max = b.extent.max()[axis];
  return {.common_m = std::max(0.0, std::min(a_max, b_max) - std::max(a_min, b_min)),
          .both_m = std::max(a_max, b_max) - std::min(a_min, b_min),
          .closer_ends_m = std::min(std::abs(a_min - b_min), std::abs(a_max - b_max))};
}

}  // namespace

Kinship KinshipOf(const Boundary& boundary, const Part& a, const Part& b) {
  const double convexity_deg = boundary.convexity_sum_deg / boundary.num_pairs;
  const double step_deg = boundary.step_sum_deg / boundary.num_pairs;
  Part both = a;
  both.Add(b);
  const double height_m = both.Height_m();
  const double flatness = std::exp(-std::min(a.Height_m(), b.Height_m()) / kFlat_m);
  const double contrast = boundary.contrast_sum / boundary.num_pairs;
  const auto [smaller_m2, larger_m2] = std::minmax(a.area_m2, b.area_m2);
  const Intervals across = Compare(a, b, 0), away = Compare(a, b, 1), upwards = Compare(a, b, 2);
  return {
      .unevenness = 1 - std::exp(-(std::abs(convexity_deg) + step_deg) / kUnevennessDeg),
      .color_likeness = std::exp(-a.color.DistanceTo(b.color) / kLikeColors),
      .top_step = std::abs(a.Top_m() - b.Top_m()) / std::max(kMinHeight_m, height_m),
      .height_m = height_m,
      .log_area = std::log(both.area_m2),
      .distance_m = std::min(both.z_sum_m / both.num_voxels, kMaxDistance_m),
      .flatness = flatness,
      .convexity_deg = convexity_deg * (1 - flatness),
      .color_continuity = std::exp(-contrast / kContrastScale),
      .contact = std::log(boundary.num_pairs / std::sqrt(std::min(a.num_voxels, b.num_voxels))),
      .log_area_ratio = std::log(smaller_m2 / larger_m2),
      .log_smaller_area = std::log(smaller_m2),
      .side_step = across.closer_ends_m / std::max(kMinExtent_m, across.both_m),
      .depth_overlap = away.common_m / std::max(kMinExtent_m, away.both_m),
      .height_overlap = upwards.common_m / std::max(kMinHeight_m, height_m),
      .rise = boundary.rise_sum_m2 / boundary.way_sum_m2,
  };
}

KinshipTerms TermsOf(const Kinship& k) {
  return {k.unevenness,
          k.color_likeness,
          k.top_step,
          k.height_m,
          k.log_area,
          k.distance_m,
          k.flatness,
          k.convexity_deg,
          k.color_continuity,
          k.log_area_ratio * k.contact,
          k.side_step * k.distance_m,
          k.top_step * k.top_step,
          k.log_area * k.color_likeness,
          k.log_smaller_area * k.height_m,
          k.depth_overlap * k.flatness,
          k.height_overlap * k.rise};
}

const std::array<std::string_view, kNumKinshipTerms>& KinshipTermNames() {
  static constexpr std::array<std::string_view, kNumKinshipTerms> kNames = {
      "unevenness",
      "color_likeness",
      "top_step",
      "height_m",
      "log_area",
      "distance_m",
      "flatness",
      "convexity_deg",
      "color_continuity",
      "log_area_ratio*contact",
      "side_step*distance_m",
      "top_step*top_step",
      "log_area*color_likeness",
      "log_smaller_area*height_m",
      "depth_overlap*flatness",
      "height_overlap*rise"};
  return kNames;
}

double LogOdds(const Kinship& kinship) {
  const KinshipTerms terms = TermsOf(kinship);
  double log_odds = kBias;
  for (std::size_t i = 0; i < terms.size(); ++i) log_odds += kWeights[i] * terms[i];
  return log_odds;
}

}  // namespace fovea
