#include "core/grasping/solid_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fovea {
namespace {

constexpr float kParallel = 1e-5F;
constexpr float kEndless = std::numeric_limits<float>::max();

// Between two planes across an axis.
bool Clip(float origin, float direction, float low_m, float high_m, Span& span) {
  if (std::abs(direction) < kParallel) return origin >= low_m && origin <= high_m;
  const float a = (low_m - origin) / direction, b = (high_m - origin) / direction;
  span.low = std::max(span.low, std::min(a, b));
  span.high = std::min(span.high, std::max(a, b));
  return span.low < span.high;
}

// Where |origin + t · direction| < radius.
bool ClipRound(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float radius_m,
               Span& span) {
  const float a = direction.squaredNorm(), c = origin.squaredNorm() - radius_m * radius_m;
  if (a < kParallel) return c <= 0;
  const float b = origin.dot(direction), root = b * b - a * c;
  if (root <= 0) return false;
  span.low = std::max(span.low, (-b - std::sqrt(root)) / a);
  span.high = std::min(span.high, (-b + std::sqrt(root)) / a);
  return span.low < span.high;
}

bool ClipPiece(const SolidPiece& piece, const Eigen::Vector3f& origin,
               const Eigen::Vector3f& direction, Span& span) {
  const Eigen::Vector3f from = origin - piece.center;
  switch (piece.kind) {
    case SolidPiece::Kind::kBox:
      for (int i = 0; i < 3; ++i) {
        if (!Clip(from[i], direction[i], -piece.half[i], piece.half[i], span)) return false;
      }
      return true;
    case SolidPiece::Kind::kSphere:
      return ClipRound(from, direction, piece.radius_m, span);
    case SolidPiece::Kind::kCylinder: {
      const float from_along = piece.axis.dot(from), along = piece.axis.dot(direction);
      return Clip(from_along, along, -piece.half_length_m, piece.half_length_m, span) &&
             ClipRound(from - from_along * piece.axis, direction - along * piece.axis,
                       piece.radius_m, span);
    }
  }
  return false;
}

SolidPiece BoxPiece(const Eigen::Vector3f& half) {
  SolidPiece piece;
  piece.half = half;
  return piece;
}

SolidPiece BallPiece(const Eigen::Vector3f& center, float radius_m) {
  SolidPiece piece;
  piece.kind = SolidPiece::Kind::kSphere;
  piece.center = center;
  piece.radius_m = radius_m;
  return piece;
}

SolidPiece RodPiece(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius_m) {
  SolidPiece piece;
  piece.kind = SolidPiece::Kind::kCylinder;
  piece.center = (from + to) / 2;
  piece.half_length_m = (to - from).norm() / 2;
  piece.axis = (to - from).normalized();
  piece.radius_m = radius_m;
  return piece;
}

// `axis`: in the axes of the box.
std::vector<SolidPiece> PiecesOfRevolution(const Shape& shape, const Eigen::Vector3f& axis) {
  std::vector<float> radii = shape.radii_m;
  if (radii.empty()) radii = {shape.radius_m};
  const float step = shape.length_m / static_cast<float>(radii.size());
  std::vector<SolidPiece> pieces;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const float low = static_cast<float>(i) * step - shape.length_m / 2;
    pieces.push_back(RodPiece(low * axis, (low + step) * axis, radii[i]));
  }
  return pieces;
}

std::vector<SolidPiece> PiecesOfOblong(const Eigen::Vector3f& half) {
  const float straight = half.x() - half.y();
  std::vector<SolidPiece> pieces = {BoxPiece({straight, half.y(), half.z()})};
  for (const float x : {-straight, straight}) {
    pieces.push_back(RodPiece({x, 0, -half.z()}, {x, 0, half.z()}, half.y()));
  }
  return pieces;
}

std::vector<SolidPiece> PiecesOfBent(const Shape& shape, const Eigen::Vector3f& half) {
  constexpr int kRods = 6;
  const float reach = half.x() - half.z();
  const auto at = [&](int i) {
    const float share = 2.0F * static_cast<float>(i) / kRods - 1;
    return Eigen::Vector3f(share * reach, shape.bend_m * (share * share - 0.5F), 0);
  };
  std::vector<SolidPiece> pieces = {BallPiece(at(0), half.z())};
  for (int i = 1; i <= kRods; ++i) {
    pieces.push_back(RodPiece(at(i - 1), at(i), half.z()));
    pieces.push_back(BallPiece(at(i), half.z()));
  }
  return pieces;
}

std::vector<SolidPiece> PiecesOf(const DetectedObject& object) {
  const Shape& shape = object.shape;
  const Eigen::Vector3f half = object.box.size_m / 2;
  const Eigen::Vector3f axis = object.box.rotation.transpose() * shape.axis;
  switch (shape.kind) {
    case Shape::Kind::kSphere:
      return {BallPiece({0, 0, 0}, shape.radius_m)};
    case Shape::Kind::kCylinder:
      return {RodPiece(-shape.length_m / 2 * axis, shape.length_m / 2 * axis, shape.radius_m)};
    case Shape::Kind::kRevolution:
      return PiecesOfRevolution(shape, axis);
    case Shape::Kind::kBox:
    case Shape::Kind::kFlat:
      break;
    case Shape::Kind::kOther:
      if (shape.form == Shape::Form::kOblong) return PiecesOfOblong(half);
      if (shape.form == Shape::Form::kBent) return PiecesOfBent(shape, half);
  }
  return {BoxPiece(half)};
}

}  // namespace

CompletedSolid::CompletedSolid(const DetectedObject& object, const LevelFrame& frame) {
  const Shape& shape = object.shape;
  const bool has_axis =
      shape.kind == Shape::Kind::kCylinder || shape.kind == Shape::Kind::kRevolution;
  center_ = frame.FromCamera(object.box.center);
  frame_from_box_ = frame.rotation.transpose() * object.box.rotation;
  half_extents_ = frame_from_box_.cwiseAbs() * object.box.size_m / 2;
  if (has_axis && shape.axis.squaredNorm() < 0.5F) {
    is_known_ = false;
    pieces_ = {BoxPiece(object.box.size_m / 2)};
    return;
  }
  if (has_axis || shape.kind == Shape::Kind::kSphere) center_ = frame.FromCamera(shape.center);
  is_known_ = shape.kind != Shape::Kind::kOther || shape.form != Shape::Form::kUnknown;
  pieces_ = PiecesOf(object);
}

std::optional<Span> CompletedSolid::Along(const Eigen::Vector3f& origin,
                                          const Eigen::Vector3f& direction) const {
  const Eigen::Vector3f from = frame_from_box_.transpose() * (origin - center_);
  const Eigen::Vector3f along = frame_from_box_.transpose() * direction;
  Span all = {kEndless, -kEndless};
  for (const SolidPiece& piece : pieces_) {
    Span part = {-kEndless, kEndless};
    if (!ClipPiece(piece, from, along, part)) continue;
    all = {std::min(all.low, part.low), std::max(all.high, part.high)};
  }
  return all.low < all.high ? std::optional(all) : std::nullopt;
}

}  // namespace fovea
