#include "core/shape/solid_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/shape/solid_residuals.h"

namespace fovea {
namespace {

// From wide to narrow: points that are far off pull at first.
constexpr std::array<float, 3> kScales = {4, 2, 1};
constexpr int kStepsPerScale = 3;
// Of twelve parts of its rim, as many must be seen.
constexpr int kMinRimParts = 4;
constexpr float kPlainlyHollow = 0.5F;  // share below the rim for which no rim need be seen
constexpr float kLeastBelow = 3;        // points below a rim that make a hollow
constexpr float kRimHeight_m = 0.01F, kRimShare = 0.9F;
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
  const float unlikeliness = Unlikeliness(solid);
  return MeanCost(residuals, scale) + unlikeliness * unlikeliness;
}

NormalEquations EquationsAround(SolidResiduals& residuals, const Solid& solid, const SeenArray& at,
                                float scale) {
  NormalEquations equations = Linearize(residuals, solid, at, scale);
  AddUnlikeliness(solid, static_cast<float>(at.size()) * scale * scale, equations);
  return equations;
}

ParameterVector Step(const NormalEquations& equations, float damping) {
  ParameterMatrix normal = equations.normal;
  normal.diagonal().array() += damping * (normal.diagonal().array() + normal.diagonal().mean());
  return normal.ldlt().solve(-equations.gradient);
}

// In how many twelfths of a turn about the axis a rim is seen.
int SeenRimParts(const LevelPoints& p, const Solid& solid) {
  std::array<bool, 12> is_seen{};
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const Eigen::Vector2f out(p.x[i] - solid.center.x(), p.y[i] - solid.center.y());
    const float share = out.norm() / solid.radius_m;
    if (share < kRimShare || share > 2 - kRimShare) continue;
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

FittedSolid FitSolid(const SeenObject& seen, const Solid& start) {
  SolidResiduals residuals(seen);
  FittedSolid fitted{start};
  SeenArray at = residuals.Of(start);
  float damping = 1e-2F;
  for (const float scale : kScales) {
    float cost = CostOf(at, fitted.solid, scale);
    std::optional<NormalEquations> equations;  // around the solid as it is
    for (int step = 0; step < kStepsPerScale; ++step) {
      if (!equations) equations = EquationsAround(residuals, fitted.solid, at, scale);
      const ParameterVector change = Step(*equations, damping);
      const Solid moved = change.allFinite() ? Moved(fitted.solid, change) : fitted.solid;
      SolidResiduals there = residuals;
      SeenArray at_there;
      float cost_there = cost;
      if (IsNear(moved, start)) {
        at_there = there.Of(moved);
        cost_there = CostOf(at_there, moved, scale);
      }
      if (cost_there < cost) {
        fitted.solid = moved;
        residuals = there;
        at = at_there;
        cost = cost_there;
        damping /= 4;
        equations.reset();
      } else {
        damping *= 8;
      }
    }
  }
  fitted.cost = MeanCost(at, 1);
  const Solid::Kind kind = fitted.solid.kind;
  if (kind == Solid::Kind::kFrustum || kind == Solid::Kind::kUprightCylinder) {
    const float below = IsBelowRim(seen, fitted.solid).sum();
    const float share = below / std::max(1.0F, IsThroughTop(seen, fitted.solid).sum());
    const bool has_rim =
        SeenRimParts(seen.points, fitted.solid) >= kMinRimParts || share > kPlainlyHollow;
    if (has_rim && below >= kLeastBelow) fitted.hollow_share = share;
    if (!has_rim && kind == Solid::Kind::kFrustum) {
      fitted.cost += below / static_cast<float>(std::max<Eigen::Index>(1, seen.points.size()));
    }
  }
  fitted.residual_m = ResidualOf(seen, fitted.solid, at);
  return fitted;
}

}  // namespace fovea
