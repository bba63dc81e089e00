#include "core/objects/object_terms.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

// Beyond these a number says no more, or nothing.
constexpr double kMinArea = 1e-5;  // m²
constexpr double kMinExtent_m = 0.005;
constexpr double kMinHeight_m = 0.003;
constexpr double kMaxDistance_m = 3;
constexpr double kMaxLogOdds = 6;
constexpr double kFewSides = 3;

double ClampedLog(double value, double least) { return std::log(std::max(value, least)); }

double Share(const BorderCounts& borders, Beyond beyond) {
  return borders.Of(beyond) / std::max(1.0, borders.Total());
}

// Things stand against walls, but what ends with the image as well as at a wall is more likely a
// strip of it.
double ClosedShare(const BorderCounts& borders) {
  const auto above = [&](Beyond beyond) { return borders.At(BorderSide::kAbove, beyond); };
  double closed = above(Beyond::kNearer) + above(Beyond::kRising) + above(Beyond::kEnd);
  if (borders.Of(Beyond::kEnd) > 0) closed += above(Beyond::kWall);
  return closed / std::max(1.0, borders.Of(BorderSide::kAbove));
}

double LogContrast(const BorderCounts& borders) {
  const double num_sides =
      borders.Of(Beyond::kLevel) + borders.Of(Beyond::kRising) + borders.Of(Beyond::kWall);
  if (num_sides <= kFewSides) return std::log(kUsualContrast);
  return ClampedLog(borders.contrast / num_sides, 1);
}

void SetShape(const ObjectEvidence& evidence, const auto& set) {
  const Part& part = evidence.part;
  const Eigen::Vector3d extent = part.extent.sizes().cast<double>();
  const double height = extent.z();
  const auto [narrow, wide] = std::minmax(extent.x(), extent.y());
  set(ObjectTerm::kArea, ClampedLog(part.area_m2, kMinArea));
  set(ObjectTerm::kLargestExtent, ClampedLog(extent.maxCoeff(), kMinExtent_m));
  set(ObjectTerm::kHeight, ClampedLog(height, kMinHeight_m));
  set(ObjectTerm::kSlenderness, ClampedLog(narrow / std::max(wide, 1e-4), 0.02));
  const double area_of_extents = extent.x() * std::max(extent.y(), height);
  set(ObjectTerm::kSolidity, ClampedLog(part.area_m2 / std::max(area_of_extents, 1e-5), 0.01));
  set(ObjectTerm::kDistance, std::clamp(part.z_sum_m / part.num_voxels, 0.0, kMaxDistance_m));
  set(ObjectTerm::kFlat, evidence.placement.num_flat / part.num_voxels);
  set(ObjectTerm::kFacingUp, evidence.placement.num_level / part.num_voxels);
}

void SetBorders(const BorderCounts& borders, const auto& set) {
  set(ObjectTerm::kClosed, ClosedShare(borders));
  set(ObjectTerm::kEndsAnywhere, borders.Of(Beyond::kEnd) > 0 ? 1 : 0);
  set(ObjectTerm::kUnmeasured, Share(borders, Beyond::kUnmeasured));
  set(ObjectTerm::kFarther, Share(borders, Beyond::kFarther));
  set(ObjectTerm::kLevelSegment, Share(borders, Beyond::kLevelSegment));
  set(ObjectTerm::kContrast, LogContrast(borders));
}

void SetJoins(const ObjectEvidence& evidence, const auto& set) {
  set(ObjectTerm::kNumSegments, std::log(evidence.num_segments));
  set(ObjectTerm::kOuterOdds, std::clamp(evidence.outer_log_odds, -kMaxLogOdds, kMaxLogOdds));
}

}  // namespace

ObjectTerms TermsOf(const ObjectEvidence& evidence) {
  ObjectTerms terms{};
  const auto set = [&](ObjectTerm term, double value) {
    terms[static_cast<std::size_t>(term)] = value;
  };
  SetShape(evidence, set);
  SetBorders(evidence.borders, set);
  SetJoins(evidence, set);
  std::copy(evidence.outer_terms.begin(), evidence.outer_terms.end(),
            terms.begin() + static_cast<int>(ObjectTerm::kNearestJoin));
  return terms;
}

std::string_view NameOf(ObjectTerm term) {
  if (term >= ObjectTerm::kNearestJoin) return "how it meets something next to it";
  static constexpr std::array<std::string_view, static_cast<std::size_t>(ObjectTerm::kNearestJoin)>
      kNames = {"its visible area",
                "its largest extent",
                "its height",
                "how slender it is",
                "how much of its extent is solid",
                "its distance",
                "how much of it is no higher than its support",
                "how much of it faces up",
                "how much of its upper border is hidden or goes on",
                "it ends with the image",
                "beyond much of its border nothing is measured",
                "what is farther away beyond its border",
                "another segment touches it",
                "how many segments it consists of",
                "how well it belongs to something next to it",
                "how its colour differs from the background"};
  return kNames[static_cast<std::size_t>(term)];
}

}  // namespace fovea
