#include "core/shape/solid_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/shape/solid_residuals.h"
#include "core/types/helpers.h"

namespace fovea {
namespace {

// From wide to narrow: points that are far off pull at first.
constexpr float kWide = 4;
constexpr std::array<float, 2> kNarrower = {2, 1};
constexpr int kStepsPerScale = 3;
// What costs so much more than the best after the first steps will not be the best.
constexpr float kHopeless = 0.1F;
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

class Search {
 public:
  Search(const SeenObject& seen, const Solid& start)
      : seen_(&seen), start_(start), solid_(start), residuals_(seen), at_(residuals_.Of(start)) {}

  // By some steps, with the residuals of this scale.
  void Improve(float scale) {
    float cost = CostOf(at_, solid_, scale);
    std::optional<NormalEquations> equations;  // around the solid as it is
    for (int step = 0; step < kStepsPerScale; ++step) {
      if (!equations) equations = EquationsAround(residuals_, solid_, at_, scale);
      const ParameterVector change = Step(*equations, damping_);
      const Solid moved = change.allFinite() ? Moved(solid_, change) : solid_;
      SolidResiduals there = residuals_;
      SeenArray at_there;
      float cost_there = cost;
      if (IsNear(moved, start_)) {
        at_there = there.Of(moved);
        cost_there = CostOf(at_there, moved, scale);
      }
      if (cost_there < cost) {
        solid_ = moved;
        residuals_ = there;
        at_ = at_there;
        cost = cost_there;
        damping_ /= 4;
        equations.reset();
      } else {
        damping_ *= 8;
      }
    }
  }

  float Cost() const { return MeanCost(at_, 1); }

  FittedSolid Found() const {
    FittedSolid found{.solid = solid_, .cost = Cost()};
    if (solid_.kind == Solid::Kind::kFrustum || solid_.kind == Solid::Kind::kUprightCylinder) {
      LookInside(found);
    }
    found.residual_m = ResidualOf(*seen_, solid_, at_);
    return found;
  }

 private:
  void LookInside(FittedSolid& found) const {
    const float below = IsBelowRim(*seen_, solid_).sum();
    const float share = below / std::max(1.0F, IsThroughTop(*seen_, solid_).sum());
    const bool has_rim =
        SeenRimParts(seen_->points, solid_) >= kMinRimParts || share > kPlainlyHollow;
    if (has_rim && below >= kLeastBelow) found.hollow_share = share;
    if (!has_rim && solid_.kind == Solid::Kind::kFrustum) {
      found.cost += below / static_cast<float>(std::max<Eigen::Index>(1, seen_->points.size()));
    }
  }

  const SeenObject* seen_;
  Solid start_, solid_;
  SolidResiduals residuals_;
  SeenArray at_;  // the residuals of the solid as it is
  float damping_ = 1e-2F;
};

}  // namespace

std::vector<FittedSolid> FitSolids(const SeenObject& seen, const std::vector<Solid>& starts) {
  std::vector<Search> searches;
  searches.reserve(starts.size());
  for (const Solid& start : starts) searches.emplace_back(seen, start);
  ForEachTogether(searches.size(), [&](std::size_t i) { searches[i].Improve(kWide); });
  float best = 1;
  for (const Search& search : searches) best = std::min(best, search.Cost());
  std::vector<FittedSolid> found(searches.size());
  ForEachTogether(searches.size(), [&](std::size_t i) {
    if (searches[i].Cost() < best + kHopeless) {
      for (const float scale : kNarrower) searches[i].Improve(scale);
    }
    found[i] = searches[i].Found();
  });
  return found;
}

}  // namespace fovea
