#include "core/shape/solid_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace fovea {
namespace {

using Eigen::ArrayXf;

// From wide to narrow: points that are far off pull at first.
constexpr std::array<float, 3> kScales = {4, 2, 1};
constexpr int kStepsPerScale = 3;
constexpr float kDifference = 1e-4F;  // metres and radians, for derivatives
// A point inside of a hollow frustum costs as much as one 0.7 standard deviations off.
constexpr float kHollowResidual = 0.7F;
// Of twelve parts of its rim, as many must be seen.
constexpr int kMinRimParts = 4;
constexpr float kRim_m = 0.006F, kRimHeight_m = 0.01F, kInnerShare = 0.9F;
constexpr float kMostGrowth = 1.6F, kRoom_m = 0.02F;

// What is not seen of a box is likely not much thinner than what is. Moves sides by tenths of a
// millimetre where they are seen, and decides where nothing else does.
float Thinness(const Solid& solid) {
  if (solid.kind != Solid::Kind::kBox) return 0;
  constexpr float kLikelyShare = 0.6F, kWeight = 0.4F;
  const float length = 2 * std::max(solid.half_length_m, solid.half_width_m);
  const float width = 2 * std::min(solid.half_length_m, solid.half_width_m);
  const float likely = kLikelyShare * std::min(length, solid.height_m);
  return width < likely ? kWeight * (likely - width) / likely : 0;
}

// 1 for the points of a hollow: seen through the top of an upright round solid, and below it.
ArrayXf IsBelowRim(const SeenObject& seen, const Solid& solid) {
  constexpr float kSurely = 2.5F;  // standard deviations
  const LevelPoints& p = seen.points;
  const float inner_m = kInnerShare * solid.radius_m;
  const Eigen::Vector3f& camera = seen.camera;
  if (camera.z() <= solid.height_m) return ArrayXf::Zero(p.size());
  // Where the lines of sight pass the height of the top.
  const ArrayXf share = (camera.z() - solid.height_m) / (camera.z() - p.h).max(kRim_m);
  const ArrayXf x = camera.x() + share * (p.x - camera.x()) - solid.center.x();
  const ArrayXf y = camera.y() + share * (p.y - camera.y()) - solid.center.y();
  const ArrayXf below = solid.height_m - p.h - (kSurely * seen.noise_m).max(kRim_m);
  return (x.square() + y.square() < inner_m * inner_m && below > 0).cast<float>();
}

// Distances, in standard deviations, of the points and of the rays, and where each ray is nearest.
class Residuals {
 public:
  explicit Residuals(const SeenObject& seen)
      : seen_(seen), on_rays_(seen.directions.size()), is_hollow_(seen.points.size()) {}

  // With the places along the rays that are nearest to this solid.
  const ArrayXf& Of(const Solid& solid) {
    FindNearest(solid);
    MarkHollow(solid);
    return AtNearest(solid);
  }

  // With those of the last call of Of().
  const ArrayXf& AtNearest(const Solid& solid) {
    const Eigen::Index num_points = seen_.points.size(), num_rays = on_rays_.size();
    all_.resize(num_points + num_rays);
    SignedDistances(solid, seen_.points, distances_, &seen_.camera);
    all_.head(num_points) = (is_hollow_ > 0).select(kHollowResidual, distances_ / seen_.noise_m);
    SignedDistances(solid, on_rays_, distances_);
    distances_ = (seen_.is_own_end > 0).select(distances_, distances_.max(0.0F));
    all_.segment(num_points, num_rays) = distances_ / seen_.outline_noise_m;
    return all_;
  }

 private:
  void PutOnRays(const ArrayXf& places) {
    on_rays_.x = seen_.camera.x() + seen_.directions.x * places;
    on_rays_.y = seen_.camera.y() + seen_.directions.y * places;
    on_rays_.h = seen_.camera.z() + seen_.directions.h * places;
  }

  // The distance from a convex solid along a ray has one minimum; golden sections find it, after
  // the first time from where it was.
  void FindNearest(const Solid& solid) {
    const Eigen::Vector3f size = solid.Size();
    const Eigen::Vector3f middle(solid.center.x(), solid.center.y(), size.z() / 2);
    const Eigen::Vector3f to = middle - seen_.camera;
    const ArrayXf squared =
        seen_.directions.x.square() + seen_.directions.y.square() + seen_.directions.h.square();
    ArrayXf reach = size.norm() / squared.sqrt();
    if (places_.size() == 0) {
      places_ = (seen_.directions.x * to.x() + seen_.directions.y * to.y() +
                 seen_.directions.h * to.z()) /
                squared;
    } else {
      reach *= 0.25F;
    }
    constexpr int kSections = 9;
    constexpr float kGolden = 0.381966F;
    ArrayXf low = places_ - reach, high = places_ + reach;
    ArrayXf a = low + kGolden * (high - low), b = high - kGolden * (high - low), at_a, at_b, at_new;
    PutOnRays(a);
    SignedDistances(solid, on_rays_, at_a);
    PutOnRays(b);
    SignedDistances(solid, on_rays_, at_b);
    for (int section = 0; section < kSections; ++section) {
      for (Eigen::Index i = 0; i < places_.size(); ++i) {  // what compilers make vectors of
        const bool is_before = at_a[i] < at_b[i];
        high[i] = is_before ? b[i] : high[i];
        low[i] = is_before ? low[i] : a[i];
        const float step = kGolden * (high[i] - low[i]);
        places_[i] = is_before ? low[i] + step : high[i] - step;
      }
      PutOnRays(places_);
      SignedDistances(solid, on_rays_, at_new);
      for (Eigen::Index i = 0; i < places_.size(); ++i) {
        const bool is_before = at_a[i] < at_b[i];
        const float kept = is_before ? a[i] : b[i], at_kept = is_before ? at_a[i] : at_b[i];
        a[i] = is_before ? places_[i] : kept;
        at_a[i] = is_before ? at_new[i] : at_kept;
        b[i] = is_before ? kept : places_[i];
        at_b[i] = is_before ? at_kept : at_new[i];
      }
    }
    places_ = (at_a < at_b).select(a, b);
    PutOnRays(places_);
  }

  void MarkHollow(const Solid& solid) {
    if (solid.kind == Solid::Kind::kFrustum) {
      is_hollow_ = IsBelowRim(seen_, solid);
    } else {
      is_hollow_.setZero();
    }
  }

  const SeenObject& seen_;
  LevelPoints on_rays_;
  ArrayXf places_;  // along the rays, of what is nearest to the solid
  ArrayXf is_hollow_, distances_, all_;
};

float MeanCost(const ArrayXf& residuals, float scale) {
  const ArrayXf squared = (residuals / scale).square();
  return (squared / (1 + squared)).mean();
}

// What may not run away where nothing holds it.
bool IsNear(const Solid& solid, const Solid& start) {
  const Eigen::Vector3f size = solid.Size(), from = start.Size();
  const float room = from.head<2>().maxCoeff() / 2 + kRoom_m;
  return (size.array() <= kMostGrowth * from.maxCoeff() + kRoom_m).all() &&
         (solid.center - start.center).norm() <= room;
}

float CostOf(const ArrayXf& residuals, const Solid& solid, float scale) {
  const float thinness = Thinness(solid);
  return MeanCost(residuals, scale) + thinness * thinness;
}

Eigen::VectorXf Step(Residuals& residuals, const Solid& solid, const ArrayXf& at, float scale,
                     float damping) {
  const int count = NumParameters(solid.kind);
  Eigen::MatrixXf derivatives(at.size(), count);
  Eigen::VectorXf thinner(count);
  const float thinness = Thinness(solid);
  for (int k = 0; k < count; ++k) {
    const Eigen::VectorXf step = Eigen::VectorXf::Unit(count, k) * kDifference;
    const Solid moved = Moved(solid, step);
    derivatives.col(k) = (residuals.AtNearest(moved) - at) / kDifference;
    thinner[k] = (Thinness(moved) - thinness) / kDifference;
  }
  const ArrayXf weights = (1 + (at / scale).square()).square().inverse();
  const Eigen::MatrixXf weighted = derivatives.array().colwise() * weights;
  Eigen::MatrixXf normal = weighted.transpose() * derivatives;
  Eigen::VectorXf gradient = weighted.transpose() * at.matrix();
  const float num_residuals = static_cast<float>(at.size()) * scale * scale;
  normal += num_residuals * thinner * thinner.transpose();
  gradient += num_residuals * thinness * thinner;
  normal.diagonal().array() += damping * (normal.diagonal().array() + normal.diagonal().mean());
  return normal.ldlt().solve(-gradient);
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

float ResidualOf(const SeenObject& seen, const Solid& solid, const ArrayXf& residuals) {
  ArrayXf distances;
  SignedDistances(solid, seen.points, distances);
  constexpr float kExplained = 3;  // standard deviations
  const auto is_explained =
      (residuals.head(seen.points.size()).abs() < kExplained).cast<float>().eval();
  return std::sqrt((distances.square() * is_explained).sum() / std::max(is_explained.sum(), 1.0F));
}

}  // namespace

FittedSolid FitSolid(const SeenObject& seen, const Solid& start) {
  Residuals residuals(seen);
  FittedSolid fitted{start};
  float damping = 1e-2F;
  for (const float scale : kScales) {
    ArrayXf at = residuals.Of(fitted.solid);
    float cost = CostOf(at, fitted.solid, scale);
    for (int step = 0; step < kStepsPerScale; ++step) {
      const Eigen::VectorXf change = Step(residuals, fitted.solid, at, scale, damping);
      const Solid moved = change.allFinite() ? Moved(fitted.solid, change) : fitted.solid;
      const ArrayXf after = residuals.Of(moved);
      const float new_cost = CostOf(after, moved, scale);
      if (new_cost < cost && IsNear(moved, start)) {
        fitted.solid = moved;
        at = after;
        cost = new_cost;
        damping /= 4;
      } else {
        damping *= 8;
        if (step + 1 < kStepsPerScale) residuals.Of(fitted.solid);
      }
    }
  }
  const ArrayXf at = residuals.Of(fitted.solid);
  fitted.cost = MeanCost(at, 1);
  const Solid::Kind kind = fitted.solid.kind;
  if (kind == Solid::Kind::kFrustum || kind == Solid::Kind::kUprightCylinder) {
    const ArrayXf is_below = IsBelowRim(seen, fitted.solid);
    const bool has_rim = SeenRimParts(seen.points, fitted.solid) >= kMinRimParts;
    if (is_below.size() > 0 && has_rim) fitted.hollow_share = is_below.mean();
    if (is_below.size() > 0 && !has_rim && kind == Solid::Kind::kFrustum) {
      fitted.cost += is_below.mean();
    }
  }
  fitted.residual_m = ResidualOf(seen, fitted.solid, at);
  return fitted;
}

}  // namespace fovea
