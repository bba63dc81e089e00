#include "core/shape/shape_fit.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "core/shape/uncertainty.h"

namespace fovea {
namespace {

// Added to the cost of a solid: of two that explain as much, the one that could explain less.
constexpr float kCostOfLying = 0, kCostOfFrustum = 0.05F, kCostOfFullFrustum = 0.12F,
                kCostOfBox = 0.02F, kCostOfOblong = 0.03F, kCostOfBent = 0.05F;
constexpr float kMostCost = 0.38F;  // of what is anything but "other"

// Whether what was seen, as large as this, may belong to such a solid, for all that is hidden of
// it.
bool MayBe(Solid::Kind kind, const Eigen::Vector3f& size_m) {
  constexpr float kMostHidden = 2.8F, kLeastSlender = 2.5F;
  const float width = (size_m.x() + size_m.y()) / 2;
  const bool is_round = size_m.x() < kMostHidden * size_m.y();
  switch (kind) {
    case Solid::Kind::kBox:
      return true;
    case Solid::Kind::kUprightCylinder:
    case Solid::Kind::kFrustum:
    case Solid::Kind::kOblong:
      return is_round;
    case Solid::Kind::kLyingCylinder:
      return size_m.z() < kMostHidden * size_m.y() && size_m.y() < kMostHidden * size_m.z();
    case Solid::Kind::kBent:
      return size_m.x() > kLeastSlender * size_m.z() && size_m.y() > size_m.z() / kMostHidden;
    case Solid::Kind::kSphere:
      return is_round && size_m.z() < kMostHidden * width && width < kMostHidden * size_m.z();
  }
  return true;
}

Solid StartOf(Solid::Kind kind, const OrientedBox& box) {
  Solid solid;
  solid.kind = kind;
  solid.half_length_m = box.size_m.x() / 2;
  solid.half_width_m = box.size_m.y() / 2;
  solid.height_m = std::max(box.size_m.z(), 0.004F);
  const bool rests = kind == Solid::Kind::kLyingCylinder || kind == Solid::Kind::kSphere ||
                     kind == Solid::Kind::kBent;
  solid.radius_m = rests ? solid.height_m / 2 : (box.size_m.x() + box.size_m.y()) / 4;
  solid.bottom_radius_m = 0.7F * solid.radius_m;
  if (kind == Solid::Kind::kBent) {
    solid.half_length_m = std::max(solid.half_length_m, 1.5F * solid.radius_m);
  }
  return solid;
}

float CostOfKind(const FittedSolid& fit) {
  switch (fit.solid.kind) {
    case Solid::Kind::kBox:
      return kCostOfBox;
    case Solid::Kind::kLyingCylinder:
      return kCostOfLying;
    case Solid::Kind::kOblong:
      return kCostOfOblong;
    case Solid::Kind::kBent:
      return kCostOfBent;
    case Solid::Kind::kFrustum:
      return IsHollow(fit) ? kCostOfFrustum : kCostOfFullFrustum;
    case Solid::Kind::kUprightCylinder:
    case Solid::Kind::kSphere:
      return 0;
  }
  return 0;
}

Shape::Kind KindOf(const FittedSolid& fit) {
  constexpr float kFlat_m = 0.03F, kFlatShare = 0.5F;
  constexpr float kEven = 0.12F, kStraight = 0.3F;  // of the radius
  const Solid& solid = fit.solid;
  switch (solid.kind) {
    case Solid::Kind::kBox: {
      const float width = 2 * std::min(solid.half_length_m, solid.half_width_m);
      const bool is_flat = solid.height_m < kFlat_m && solid.height_m < kFlatShare * width;
      return is_flat ? Shape::Kind::kFlat : Shape::Kind::kBox;
    }
    case Solid::Kind::kUprightCylinder:
      return IsHollow(fit) ? Shape::Kind::kRevolution : Shape::Kind::kCylinder;
    case Solid::Kind::kLyingCylinder:
      return Shape::Kind::kCylinder;
    case Solid::Kind::kOblong:
      return Shape::Kind::kOther;
    case Solid::Kind::kBent:
      return std::abs(solid.bend_m) < kStraight * solid.radius_m ? Shape::Kind::kCylinder
                                                                 : Shape::Kind::kOther;
    case Solid::Kind::kSphere:
      return Shape::Kind::kSphere;
    case Solid::Kind::kFrustum: {
      const bool is_even =
          std::abs(solid.radius_m - solid.bottom_radius_m) < kEven * solid.radius_m &&
          solid.bulge_m < kEven * solid.radius_m;
      return is_even && !IsHollow(fit) ? Shape::Kind::kCylinder : Shape::Kind::kRevolution;
    }
  }
  return Shape::Kind::kOther;
}

// One of each kind that it may be.
std::vector<FittedSolid> FitKinds(const SeenObject& seen, const OrientedBox& start,
                                  std::initializer_list<Solid::Kind> kinds) {
  std::vector<Solid> starts;
  starts.reserve(kinds.size());
  for (const Solid::Kind kind : kinds) {
    if (MayBe(kind, start.size_m)) starts.push_back(StartOf(kind, start));
  }
  return FitSolids(seen, starts);
}

// Those that have names, and where none of them explains what was seen well, those that have none.
std::vector<FittedSolid> FitLikelyKinds(const SeenObject& seen, const OrientedBox& start) {
  constexpr float kWell = 0.1F;
  using Kind = Solid::Kind;
  std::vector<FittedSolid> fits = FitKinds(
      seen, start,
      {Kind::kBox, Kind::kUprightCylinder, Kind::kLyingCylinder, Kind::kSphere, Kind::kFrustum});
  const auto best = std::min_element(fits.begin(), fits.end(),
                                     [](const auto& a, const auto& b) { return a.cost < b.cost; });
  if (best->cost < kWell) return fits;
  const std::vector<FittedSolid> more = FitKinds(seen, start, {Kind::kOblong, Kind::kBent});
  fits.insert(fits.end(), more.begin(), more.end());
  return fits;
}

Shape::Form FormOf(const FittedShape& shape) {
  if (shape.kind != Shape::Kind::kOther || shape.fit.cost >= kMostCost)
    return Shape::Form::kUnknown;
  return shape.fit.solid.kind == Solid::Kind::kOblong ? Shape::Form::kOblong : Shape::Form::kBent;
}

}  // namespace

bool IsHollow(const FittedSolid& fit) {
  constexpr float kMinShare = 0.2F;
  return fit.hollow_share >= kMinShare;
}

FittedShape FitShape(const DetectedObject& object, const std::vector<OutlinePoint>& outline,
                     const CameraIntrinsics& intrinsics, const LevelFrame& frame) {
  const SeenObject seen = See(object, outline, intrinsics, frame);
  OrientedBox start = object.visible_box;
  const Eigen::Vector3f top = start.center + frame.rotation.col(2) * (start.size_m.z() / 2);
  start.size_m.z() = frame.FromCamera(top).z();
  FittedShape best;
  float odds = 0;
  for (const FittedSolid& fit : FitLikelyKinds(seen, start)) {
    const float cost = fit.cost + CostOfKind(fit);
    const float squared = std::max(cost, 0.02F) * std::max(cost, 0.02F);
    odds += 1 / (squared * squared);
    if (cost >= best.cost) continue;
    best.cost = cost;
    best.fit = fit;
    best.confidence = 1 / (squared * squared);
  }
  best.confidence /= odds;
  best.kind = best.fit.cost < kMostCost ? KindOf(best.fit) : Shape::Kind::kOther;
  best.form = FormOf(best);
  const bool is_other = best.kind == Shape::Kind::kOther && best.form == Shape::Form::kUnknown;
  best.uncertainty = UncertaintyOf(
      seen, is_other ? StartOf(Solid::Kind::kBox, start) : best.fit.solid, best.fit.cost);
  return best;
}

}  // namespace fovea
