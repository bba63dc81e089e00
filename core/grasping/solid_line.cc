#include "core/grasping/solid_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/types/widest_registers.h"

namespace fovea {
namespace {

constexpr float kParallel = 1e-5F;
constexpr float kEndless = std::numeric_limits<float>::max();
constexpr std::size_t kLanes = 32;

using Lanes = std::array<float, kLanes>;
using Lanes3 = std::array<Lanes, 3>;

// Lines in the axes of the box, from the middle of the solid, and where they are in it.
struct Bundle {
  Lanes3 from, along;
  Lanes low, high;
};

// Always in the same order: the last bit depends on it.
FOVEA_INLINE float Sum(float a, float b, float c) { return a + (b + c); }

FOVEA_INLINE void Narrow(float low, float high, Span& span) {
  span.low = std::max(span.low, low);
  span.high = std::min(span.high, high);
}

FOVEA_INLINE void EmptyUnless(bool stays, Span& span) { span.high = stays ? span.high : -kEndless; }

// Between two planes across an axis, as far on both sides.
FOVEA_INLINE void Clip(float origin, float direction, float half_m, Span& span) {
  const bool is_parallel = std::abs(direction) < kParallel;
  const bool is_inside = std::abs(origin) <= half_m;
  const float a = (-half_m - origin) / direction, b = (half_m - origin) / direction;
  const float low = std::min(a, b), high = std::max(a, b);
  Narrow(is_parallel ? -kEndless : low, is_parallel ? kEndless : high, span);
  EmptyUnless(!is_parallel || is_inside, span);
}

// Where |origin + t · direction| < radius; `a`, `b`, `c`: of the square, a t² + 2 b t + c.
FOVEA_INLINE void ClipRound(float a, float b, float c, Span& span) {
  const bool is_parallel = a < kParallel;
  const float square = b * b - a * c;
  const float root = std::sqrt(std::max(square, 0.0F));
  Narrow(is_parallel ? -kEndless : (-b - root) / a, is_parallel ? kEndless : (-b + root) / a, span);
  EmptyUnless(is_parallel ? c <= 0 : square > 0, span);
}

FOVEA_INLINE void Join(const Span& span, std::size_t i, Bundle& bundle) {
  const bool is_empty = span.IsEmpty();
  bundle.low[i] = std::min(bundle.low[i], is_empty ? kEndless : span.low);
  bundle.high[i] = std::max(bundle.high[i], is_empty ? -kEndless : span.high);
}

FOVEA_INLINE void JoinBox(const SolidPiece& piece, Bundle& bundle) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    Span span = {-kEndless, kEndless};
    for (int axis = 0; axis < 3; ++axis) {
      Clip(bundle.from[axis][i] - piece.center[axis], bundle.along[axis][i], piece.half[axis],
           span);
    }
    Join(span, i, bundle);
  }
}

FOVEA_INLINE void JoinBall(const SolidPiece& piece, Bundle& bundle) {
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float x = bundle.from[0][i] - piece.center[0], y = bundle.from[1][i] - piece.center[1],
                z = bundle.from[2][i] - piece.center[2];
    const float u = bundle.along[0][i], v = bundle.along[1][i], w = bundle.along[2][i];
    Span span = {-kEndless, kEndless};
    ClipRound(Sum(u * u, v * v, w * w), Sum(x * u, y * v, z * w),
              Sum(x * x, y * y, z * z) - piece.radius_m * piece.radius_m, span);
    Join(span, i, bundle);
  }
}

FOVEA_INLINE void JoinRod(const SolidPiece& piece, Bundle& bundle) {
  const float p = piece.axis[0], q = piece.axis[1], r = piece.axis[2];
  for (std::size_t i = 0; i < kLanes; ++i) {
    float x = bundle.from[0][i] - piece.center[0], y = bundle.from[1][i] - piece.center[1],
          z = bundle.from[2][i] - piece.center[2];
    float u = bundle.along[0][i], v = bundle.along[1][i], w = bundle.along[2][i];
    const float from_along = Sum(p * x, q * y, r * z), along = Sum(p * u, q * v, r * w);
    Span span = {-kEndless, kEndless};
    Clip(from_along, along, piece.half_length_m, span);
    x -= from_along * p, y -= from_along * q, z -= from_along * r;
    u -= along * p, v -= along * q, w -= along * r;
    ClipRound(Sum(u * u, v * v, w * w), Sum(x * u, y * v, z * w),
              Sum(x * x, y * y, z * z) - piece.radius_m * piece.radius_m, span);
    Join(span, i, bundle);
  }
}

FOVEA_INLINE void JoinPiece(const SolidPiece& piece, Bundle& bundle) {
  switch (piece.kind) {
    case SolidPiece::Kind::kBox:
      return JoinBox(piece, bundle);
    case SolidPiece::Kind::kSphere:
      return JoinBall(piece, bundle);
    case SolidPiece::Kind::kCylinder:
      return JoinRod(piece, bundle);
  }
}

// Lines from `first` on, seen along the columns of `axes`; lanes without one repeat the last.
FOVEA_INLINE void Load(const Lines& lines, std::size_t first, const Eigen::Vector3f& center,
                       const Eigen::Matrix3f& axes, Bundle& bundle) {
  Lanes3 origins, directions;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      const std::size_t line = std::min(first + i, lines.Size() - 1);
      origins[axis][i] = lines.Origins(axis)[line] - center[axis];
      directions[axis][i] = lines.Directions(axis)[line];
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    const float x = axes(0, axis), y = axes(1, axis), z = axes(2, axis);
    for (std::size_t i = 0; i < kLanes; ++i) {
      bundle.from[axis][i] = Sum(x * origins[0][i], y * origins[1][i], z * origins[2][i]);
      bundle.along[axis][i] = Sum(x * directions[0][i], y * directions[1][i], z * directions[2][i]);
    }
  }
  bundle.low.fill(kEndless);
  bundle.high.fill(-kEndless);
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
    pieces_.resize(1);
    pieces_[0].half = object.box.size_m / 2;
    return;
  }
  if (has_axis || shape.kind == Shape::Kind::kSphere) center_ = frame.FromCamera(shape.center);
  // Of what has no depth nothing but the box is known: its points are a guess at the box's front.
  is_known_ = object.depth_missing || shape.kind != Shape::Kind::kOther ||
              shape.form != Shape::Form::kUnknown;
  pieces_ = PiecesOf(object);
}

void CompletedSolid::Along(const Lines& lines, std::vector<Span>& spans) const {
  spans.resize(lines.Size());
  Bundle bundle;
  for (std::size_t first = 0; first < lines.Size(); first += kLanes) {
    RunInWidestRegisters([&] {
      Load(lines, first, center_, frame_from_box_, bundle);
      for (const SolidPiece& piece : pieces_) JoinPiece(piece, bundle);
    });
    const std::size_t count = std::min(kLanes, lines.Size() - first);
    for (std::size_t i = 0; i < count; ++i) spans[first + i] = {bundle.low[i], bundle.high[i]};
  }
}

}  // namespace fovea
