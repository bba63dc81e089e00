#include "core/shape/solid_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace fovea {
namespace {

// From wide to narrow: points that are far off pull at first.
constexpr std::array<float, 2> kWideScales = {4, 2};
constexpr float kNarrowScale = 1;
constexpr int kWideSteps = 3, kNarrowSteps = 6;
// Of twelve parts of its rim, as many must be seen.
constexpr int kMinRimParts = 4;
constexpr float kRimHeight_m = 0.01F, kInnerShare = 0.9F;
constexpr float kMostGrowth = 1.6F, kRoom_m = 0.02F;

float MeanCost(const SeenArray& residuals, float scale) {
  const SeenArray squared = (residuals / scale).square();
  return (squared / (1 + squared)).mean();
}

// What may not run away where nothing holds it.
bool IsNear(const Solid& solid, const Solid& start) {
  const Eigen::Vector3f size = solid.Size(), from = start.Size();
  const float room = from.head<2>().maxCoeff() / 2 + kRoom_m;
  return (size.array() <= kMostGrowth * from.maxCoeff() + kRoom_m).all() &&
         (solid.center - start.center).norm() <= room;
}

float CostOf(const SeenArray& residuals, const Solid& solid, float scale) {
  const float thinness = Thinness(solid);
  return MeanCost(residuals, scale) + thinness * thinness;
}

ParameterVector Step(SolidResiduals& residuals, const Solid& solid, const SeenArray& at,
                     float scale, float damping) {
  NormalEquations equations = Linearize(residuals, solid, at, scale);
  AddThinness(solid, static_cast<float>(at.size()) * scale * scale, equations);
  ParameterMatrix& normal = equations.normal;
  normal.diagonal().array() += damping * (normal.diagonal().array() + normal.diagonal().mean());
  return normal.ldlt().solve(-equations.gradient);
}

// In how many twelfths of a turn about the axis a rim is seen.
int SeenRimParts(const LevelPoints& p, const Solid& solid) {
  std::array<bool, 12> is_seen{};
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const Eigen::Vector2f out(p.x[i] - solid.center.x(), p.y[i] - solid.center.y());
    const float share = out.norm() / solid.radius_m;
    if (share < kInnerShare || share > 2 - kInnerShare) continue;
    if (std::abs(p.h[i] - solid.height_m) > kRimHeight_m) continue;
    // Twelfths without an arc tangent: the quadrant, and in it tangents of 30 and 60 degrees.
    const float x = std::abs(out.x()), y = std::abs(out.y());
    const std::size_t third = y < 0.57735F * x ? 0 : y < 1.73205F * x ? 1 : 2;
    is_seen[third + (out.x() < 0 ? 3U : 0U) + (out.y() < 0 ? 6U : 0U)] = true;
  }
  return static_cast<int>(std::count(is_seen.begin(), is_seen.end(), true));
}

float ResidualOf(const SeenObject& seen, const Solid& solid, const SeenArray& residuals) {
  SeenArray distances;
  SignedDistances(solid, seen.points, distances);
  constexpr float kExplained = 3;  // standard deviations
  const auto is_explained =
      (residuals.head(seen.points.size()).abs() < kExplained).cast<float>().eval();
  return std::sqrt((distances.square() * is_explained).sum() / std::max(is_explained.sum(), 1.0F));
}

}  // namespace

SolidFitting::SolidFitting(const SeenObject& seen, const Solid& start)
    : seen_(seen), start_(start), solid_(start), residuals_(seen), at_(residuals_.Of(start)) {
  for (const float scale : kWideScales) Descend(scale, kWideSteps);
}

float SolidFitting::Cost() const { return MeanCost(at_, kNarrowScale); }

void SolidFitting::Finish() { Descend(kNarrowScale, kNarrowSteps); }

void SolidFitting::Descend(float scale, int num_steps) {
  for (int step = 0; step < num_steps; ++step) {
    const ParameterVector change = Step(residuals_, solid_, at_, scale, damping_);
    const Solid moved = change.allFinite() ? Moved(solid_, change) : solid_;
    // With the places along the rays as they are: where the solid touches them changes little.
    const float cost = CostOf(residuals_.AtNearest(moved), moved, scale);
    const bool is_better = cost < CostOf(at_, solid_, scale) && IsNear(moved, start_);
    damping_ *= is_better ? 0.25F : 8;
    if (!is_better) continue;
    solid_ = moved;
    at_ = residuals_.Of(solid_);
  }
}

FittedSolid SolidFitting::Result() {
  FittedSolid fitted{solid_, Cost()};
  if (solid_.kind == Solid::Kind::kFrustum || solid_.kind == Solid::Kind::kUprightCylinder) {
    const SeenArray is_below = IsBelowRim(seen_, solid_);
    const bool has_rim = SeenRimParts(seen_.points, solid_) >= kMinRimParts;
    if (is_below.size() > 0 && has_rim) fitted.hollow_share = is_below.mean();
    if (is_below.size() > 0 && !has_rim && solid_.kind == Solid::Kind::kFrustum) {
      fitted.cost += is_below.mean();
    }
  }
  fitted.residual_m = ResidualOf(seen_, solid_, at_);
  return fitted;
}

}  // namespace fovea
