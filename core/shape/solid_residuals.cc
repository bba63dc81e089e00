#include "core/shape/solid_residuals.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/shape/solid_distances.h"

namespace fovea {
namespace {

constexpr float kDifference = 1e-4F;  // metres and radians, for derivatives
// A point inside of a hollow solid, far from its inner surface, costs as much as one 0.7 standard
// deviations off: what is inside may have any shape.
constexpr float kHollowResidual = 0.7F;
constexpr float kWall_m = 0.0035F, kWallNoise_m = 0.0015F;  // of vessels of a household
constexpr float kRim_m = 0.006F, kInnerShare = 0.9F;

}  // namespace

float Unlikeliness(const Solid& solid) {
  constexpr float kOblongWeight = 0.1F;
  if (solid.kind == Solid::Kind::kOblong) {
    return kOblongWeight * (solid.half_length_m / solid.half_width_m - 1);
  }
  if (solid.kind != Solid::Kind::kBox) return 0;
  constexpr float kLikelyShare = 0.6F, kWeight = 0.4F;
  const float length = 2 * std::max(solid.half_length_m, solid.half_width_m);
  const float width = 2 * std::min(solid.half_length_m, solid.half_width_m);
  const float likely = kLikelyShare * std::min(length, solid.height_m);
  return width < likely ? kWeight * (likely - width) / likely : 0;
}

SeenArray IsThroughTop(const SeenObject& seen, const Solid& solid) {
  const LevelPoints& p = seen.points;
  const float inner_m = kInnerShare * solid.radius_m;
  const Eigen::Vector3f& camera = seen.camera;
  if (camera.z() <= solid.height_m) return SeenArray::Zero(p.size());
  // Where the lines of sight pass the height of the top.
  const SeenArray share = (camera.z() - solid.height_m) / (camera.z() - p.h).max(kRim_m);
  const SeenArray x = camera.x() + share * (p.x - camera.x()) - solid.center.x();
  const SeenArray y = camera.y() + share * (p.y - camera.y()) - solid.center.y();
  return (x.square() + y.square() < inner_m * inner_m).cast<float>();
}

SeenArray IsBelowRim(const SeenObject& seen, const Solid& solid) {
  constexpr float kSurely = 2;  // standard deviations
  const SeenArray below = solid.height_m - seen.points.h - (kSurely * seen.noise_m).max(kRim_m);
  return IsThroughTop(seen, solid) * (below > 0).cast<float>();
}

SolidResiduals::SolidResiduals(const SeenObject& seen)
    : seen_(&seen), on_rays_(seen.directions.size()) {
  if (seen.points.size() + seen.directions.size() > kMaxSeen) {
    throw std::length_error("points and rays of an object: more than kMaxSeen");
  }
}

const SeenArray& SolidResiduals::Of(const Solid& solid) {
  FindNearest(solid);
  MarkHollow(solid);
  return AtNearest(solid);
}

const SeenArray& SolidResiduals::AtNearest(const Solid& solid) {
  const Eigen::Index num_points = seen_->points.size(), num_rays = on_rays_.size();
  all_.resize(num_points + num_rays);
  SignedDistances(solid, seen_->points, distances_, &seen_->camera);
  RunInWidestRegisters([&] {
    for (Eigen::Index i = 0; i < num_points; ++i) all_[i] = distances_[i] / seen_->noise_m[i];
  });
  if (has_hollow_) {
    const SeenArray inside = DistancesInside(solid, seen_->points, kWall_m);
    RunInWidestRegisters([&] {
      for (Eigen::Index i = 0; i < num_points; ++i) {
        const float off = inside[i] / (seen_->noise_m[i] + kWallNoise_m);
        const float bounded = kHollowResidual * off / std::sqrt(1 + Squared(off));
        all_[i] = is_hollow_[i] > 0 ? bounded : all_[i];
      }
    });
  }
  SignedDistances(solid, on_rays_, distances_);
  RunInWidestRegisters([&] {
    for (Eigen::Index i = 0; i < num_rays; ++i) {
      const float beyond = std::max(distances_[i], 0.0F);
      const float distance = seen_->is_own_end[i] > 0 ? distances_[i] : beyond;
      all_[num_points + i] = distance / seen_->outline_noise_m[i];
    }
  });
  return all_;
}

// By golden sections, from the places along the rays less and more `reach` on.
template <typename Distance>
void SolidResiduals::Narrow(const Distance& distance, const SeenArray& reach, int num_sections) {
  constexpr float kGolden = 0.381966F;
  RunInWidestRegisters([&] {
    // Copies, which compilers know to lie apart.
    const LevelPoints directions = seen_->directions;
    const Eigen::Vector3f camera = seen_->camera;
    const Eigen::Index count = directions.size();
    SeenArray low = places_ - reach, high = places_ + reach;
    SeenArray a = low + kGolden * (high - low), b = high - kGolden * (high - low);
    SeenArray place(count), at_a(count), at_b(count), at_place(count);
    const auto look = [&](const SeenArray& places, SeenArray& at) {
      for (Eigen::Index i = 0; i < count; ++i) {
        at[i] = distance(camera.x() + directions.x[i] * places[i],
                         camera.y() + directions.y[i] * places[i],
                         camera.z() + directions.h[i] * places[i]);
      }
    };
    look(a, at_a);
    look(b, at_b);
    for (int section = 0; section < num_sections; ++section) {
      for (Eigen::Index i = 0; i < count; ++i) {
        const bool is_before = at_a[i] < at_b[i];
        high[i] = is_before ? b[i] : high[i];
        low[i] = is_before ? low[i] : a[i];
        const float step = kGolden * (high[i] - low[i]);
        place[i] = is_before ? low[i] + step : high[i] - step;
      }
      look(place, at_place);
      for (Eigen::Index i = 0; i < count; ++i) {
        const bool is_before = at_a[i] < at_b[i];
        const float kept = is_before ? a[i] : b[i], at_kept = is_before ? at_a[i] : at_b[i];
        a[i] = is_before ? place[i] : kept;
        at_a[i] = is_before ? at_place[i] : at_kept;
        b[i] = is_before ? kept : place[i];
        at_b[i] = is_before ? at_kept : at_place[i];
      }
    }
    for (Eigen::Index i = 0; i < count; ++i) places_[i] = at_a[i] < at_b[i] ? a[i] : b[i];
  });
}

// The distance from a convex solid along a ray has one minimum; golden sections find it to a
// fiftieth of the solid's size, and after the first time, near where it was, four times as well.
void SolidResiduals::FindNearest(const Solid& solid) {
  const LevelPoints& directions = seen_->directions;
  const Eigen::Vector3f size = solid.Size();
  const Eigen::Vector3f middle(solid.center.x(), solid.center.y(), size.z() / 2);
  const Eigen::Vector3f to = middle - seen_->camera;
  const SeenArray squared = directions.x.square() + directions.y.square() + directions.h.square();
  constexpr int kSections = 9, kSectionsNear = 6;
  constexpr float kNear = 0.06F;  // of the size
  int num_sections = kSections;
  SeenArray reach = size.norm() / squared.sqrt();
  if (places_.size() == 0) {
    places_ = (directions.x * to.x() + directions.y * to.y() + directions.h * to.z()) / squared;
  } else {
    reach *= kNear;
    num_sections = kSectionsNear;
  }
  WithDistanceFrom(solid, [&](const auto& distance) { Narrow(distance, reach, num_sections); });
  on_rays_.x = seen_->camera.x() + directions.x * places_;
  on_rays_.y = seen_->camera.y() + directions.y * places_;
  on_rays_.h = seen_->camera.z() + directions.h * places_;
}

void SolidResiduals::MarkHollow(const Solid& solid) {
  if (solid.kind == Solid::Kind::kFrustum || solid.kind == Solid::Kind::kUprightCylinder) {
    is_hollow_ = IsBelowRim(*seen_, solid);
    has_hollow_ = is_hollow_.any();
  }
}

NormalEquations Linearize(SolidResiduals& residuals, const Solid& solid, const SeenArray& at,
                          float scale) {
  const int count = NumParameters(solid.kind);
  using Derivatives = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                    kMaxSeen, kMaxParameters>;
  Derivatives derivatives(at.size(), count);
  for (int k = 0; k < count; ++k) {
    const ParameterVector step = ParameterVector::Unit(count, k) * kDifference;
    derivatives.col(k) = (residuals.AtNearest(Moved(solid, step)) - at) / kDifference;
  }
  const SeenArray weights = (1 + (at / scale).square()).square().inverse();
  NormalEquations equations{ParameterMatrix(count, count), ParameterVector(count)};
  for (int k = 0; k < count; ++k) {
    const SeenArray weighted = derivatives.col(k).array() * weights;
    for (int other = k; other < count; ++other) {
      const float product = weighted.matrix().dot(derivatives.col(other));
      equations.normal(k, other) = equations.normal(other, k) = product;
    }
    equations.gradient[k] = weighted.matrix().dot(at.matrix());
  }
  return equations;
}

void AddUnlikeliness(const Solid& solid, float weight, NormalEquations& equations) {
  const auto count = static_cast<int>(equations.gradient.size());
  const float unlikeliness = Unlikeliness(solid);
  ParameterVector growth(count);
  for (int k = 0; k < count; ++k) {
    const Solid moved = Moved(solid, ParameterVector::Unit(count, k) * kDifference);
    growth[k] = (Unlikeliness(moved) - unlikeliness) / kDifference;
  }
  equations.normal += weight * growth * growth.transpose();
  equations.gradient += weight * unlikeliness * growth;
}

}  // namespace fovea
