#include "core/grasping/solid_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fovea {
namespace {

constexpr float kParallel = 1e-5F;
constexpr float kEndless = std::numeric_limits<float>::max();

// Between two planes across axis `i`, half_m to either side of 0.
bool Clip(float origin, float direction, float low_m, float high_m, Span& span) {
  if (std::abs(direction) < kParallel) return origin >= low_m && origin <= high_m;
  const float a = (low_m - origin) / direction, b = (high_m - origin) / direction;
  span.low = std::max(span.low, std::min(a, b));
  span.high = std::min(span.high, std::max(a, b));
  return span.low < span.high;
}

// Where |origin + t · direction| < radius, of any number of dimensions.
template <typename Vector>
bool ClipRound(const Vector& origin, const Vector& direction, float radius_m, Span& span) {
  const float a = direction.squaredNorm(), c = origin.squaredNorm() - radius_m * radius_m;
  if (a < kParallel) return c <= 0;
  const float b = origin.dot(direction), root = b * b - a * c;
  if (root <= 0) return false;
  span.low = std::max(span.low, (-b - std::sqrt(root)) / a);
  span.high = std::min(span.high, (-b + std::sqrt(root)) / a);
  return span.low < span.high;
}

// A cylinder about the third axis from low_m to high_m of it.
bool ClipCylinder(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float radius_m,
                  float low_m, float high_m, Span& span) {
  return Clip(origin.z(), direction.z(), low_m, high_m, span) &&
         ClipRound<Eigen::Vector2f>(origin.head<2>(), direction.head<2>(), radius_m, span);
}

Eigen::Matrix3f AxesAlong(const Eigen::Vector3f& axis) {
  Eigen::Matrix3f axes;
  axes.col(2) = axis;
  axes.col(0) = axis.unitOrthogonal();
  axes.col(1) = axis.cross(axes.col(0));
  return axes;
}

}  // namespace

CompletedSolid::CompletedSolid(const DetectedObject& object, const LevelFrame& frame)
    : kind_(object.shape.kind), half_box_(object.box.size_m / 2) {
  const Shape& shape = object.shape;
  const bool has_axis = kind_ == Shape::Kind::kCylinder || kind_ == Shape::Kind::kRevolution;
  if (has_axis && shape.axis.squaredNorm() < 0.5F) kind_ = Shape::Kind::kOther;
  center_ = frame.FromCamera(object.box.center);
  frame_from_box_ = frame.rotation.transpose() * object.box.rotation;
  half_extents_ = frame_from_box_.cwiseAbs() * half_box_;
  if (kind_ == Shape::Kind::kSphere || has_axis) {
    center_ = frame.FromCamera(shape.center);
    radius_m_ = shape.radius_m;
    half_length_m_ = shape.length_m / 2;
    radii_m_ = shape.radii_m;
  }
  if (kind_ == Shape::Kind::kRevolution && radii_m_.empty()) radii_m_ = {radius_m_};
  if (has_axis) frame_from_box_ = AxesAlong(frame.rotation.transpose() * shape.axis);
}

std::optional<Span> CompletedSolid::Along(const Eigen::Vector3f& origin,
                                          const Eigen::Vector3f& direction) const {
  const Eigen::Vector3f from = frame_from_box_.transpose() * (origin - center_);
  const Eigen::Vector3f along = frame_from_box_.transpose() * direction;
  Span span = {-kEndless, kEndless};
  switch (kind_) {
    case Shape::Kind::kSphere:
      return ClipRound<Eigen::Vector3f>(from, along, radius_m_, span) ? std::optional(span)
                                                                      : std::nullopt;
    case Shape::Kind::kCylinder:
      return ClipCylinder(from, along, radius_m_, -half_length_m_, half_length_m_, span)
                 ? std::optional(span)
                 : std::nullopt;
    case Shape::Kind::kRevolution: {
      Span all = {kEndless, -kEndless};
      const float step = 2 * half_length_m_ / static_cast<float>(radii_m_.size());
      for (std::size_t i = 0; i < radii_m_.size(); ++i) {
        const float low = -half_length_m_ + static_cast<float>(i) * step;
        Span part = {-kEndless, kEndless};
        if (!ClipCylinder(from, along, radii_m_[i], low, low + step, part)) continue;
        all = {std::min(all.low, part.low), std::max(all.high, part.high)};
      }
      return all.low < all.high ? std::optional(all) : std::nullopt;
    }
    default:
      for (int i = 0; i < 3; ++i) {
        if (!Clip(from[i], along[i], -half_box_[i], half_box_[i], span)) return std::nullopt;
      }
      return span;
  }
}

}  // namespace fovea
