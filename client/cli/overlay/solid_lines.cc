#include "client/cli/overlay/solid_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "client/cli/geometry.h"

namespace fovea::cli {
namespace {

constexpr int kSteps = 48;  // of a ring

// Any two unit vectors across a unit vector and each other.
std::pair<cv::Vec3d, cv::Vec3d> Across(const cv::Vec3d& axis) {
  const cv::Vec3d other = std::abs(axis[0]) < 0.7 ? cv::Vec3d(1, 0, 0) : cv::Vec3d(0, 1, 0);
  const cv::Vec3d first = cv::normalize(axis.cross(other));
  return {first, axis.cross(first)};
}

// Of a round solid: where on its axis, and how wide there.
struct Ring {
  cv::Vec3d center;
  double radius = 0;
};

// `all_seen`: it bounds a face that the camera looks at; else only what faces the camera is seen.
void AddRing(const Ring& ring, const cv::Vec3d& axis, bool all_seen,
             std::vector<SpaceLine>* lines) {
  const auto across = Across(axis);
  const auto at = [&](int step) {
    const double angle = 2 * std::numbers::pi * step / kSteps;
    return ring.radius * (std::cos(angle) * across.first + std::sin(angle) * across.second);
  };
  for (int step = 0; step < kSteps; ++step) {
    const cv::Vec3d from = at(step), to = at(step + 1);
    const bool seen = all_seen || from.dot(ring.center + from) < 0;
    lines->push_back({ring.center + from, ring.center + to, !seen});
  }
}

// Where lines of sight touch the ring's wall; none where the camera looks along the axis.
std::optional<std::pair<cv::Vec3d, cv::Vec3d>> Tangents(const Ring& ring, const cv::Vec3d& axis) {
  const cv::Vec3d away = ring.center - ring.center.dot(axis) * axis;
  const double distance = cv::norm(away);
  if (!(distance > ring.radius)) return std::nullopt;
  const cv::Vec3d towards = -1 / distance * away, aside = axis.cross(towards);
  const double cosine = ring.radius / distance, sine = std::sqrt(1 - cosine * cosine);
  return std::pair{ring.center + ring.radius * (cosine * towards + sine * aside),
                   ring.center + ring.radius * (cosine * towards - sine * aside)};
}

void AddOutline(const std::vector<Ring>& rings, const cv::Vec3d& axis,
                std::vector<SpaceLine>* lines) {
  for (std::size_t i = 1; i < rings.size(); ++i) {
    const auto below = Tangents(rings[i - 1], axis), above = Tangents(rings[i], axis);
    if (!below || !above) continue;
    lines->push_back({below->first, above->first});
    lines->push_back({below->second, above->second});
  }
}

// From one end of the axis to the other.
std::vector<Ring> RingsOf(const v1::Shape& shape, const cv::Vec3d& axis) {
  const cv::Vec3d center = ToVec(shape.center()), half = shape.length_m() / 2 * axis;
  const int n = shape.radii_m_size();
  if (shape.kind() != v1::SHAPE_KIND_REVOLUTION || n == 0) {
    return {{center - half, shape.radius_m()}, {center + half, shape.radius_m()}};
  }
  std::vector<Ring> rings{{center - half, shape.radii_m(0)}};
  for (int i = 0; i < n; ++i) {
    rings.push_back({center + ((2.0 * i + 1) / n - 1) * half, shape.radii_m(i)});
  }
  rings.push_back({center + half, shape.radii_m(n - 1)});
  return rings;
}

std::vector<SpaceLine> RoundLines(const v1::Shape& shape) {
  constexpr std::size_t kMostRings = 2;  // between the ends
  const cv::Vec3d axis = cv::normalize(ToVec(shape.axis()));
  const std::vector<Ring> rings = RingsOf(shape, axis);
  std::vector<SpaceLine> lines;
  const auto ends_seen = [&](const Ring& end, double side) {
    return side * axis.dot(end.center) < 0;
  };
  AddRing(rings.front(), axis, ends_seen(rings.front(), -1), &lines);
  AddRing(rings.back(), axis, ends_seen(rings.back(), 1), &lines);
  const std::size_t every = std::max<std::size_t>(1, (rings.size() - 1) / (kMostRings + 1));
  for (std::size_t i = every; i + 1 < rings.size(); i += every) {
    AddRing(rings[i], axis, false, &lines);
  }
  AddOutline(rings, axis, &lines);
  return lines;
}

// Its outline, and a level ring about its middle.
std::vector<SpaceLine> BallLines(const v1::Object& object) {
  const cv::Vec3d center = ToVec(object.shape().center());
  const double radius = object.shape().radius_m(), distance = cv::norm(center);
  std::vector<SpaceLine> lines;
  if (!(distance > radius)) return lines;
  const double share = radius / distance;
  AddRing({(1 - share * share) * center, radius * std::sqrt(1 - share * share)},
          1 / distance * center, true, &lines);
  const cv::Vec3d up = cv::normalize(BlockOf(object.oriented_box()).half_axes[2]);
  AddRing({center, radius}, up, false, &lines);
  return lines;
}

bool HasAxis(const v1::Shape& shape) {
  return shape.has_center() && shape.has_axis() && shape.length_m() > 0;
}

}  // namespace

std::vector<SpaceLine> LinesOf(const v1::Object& object) {
  const v1::Shape& shape = object.shape();
  if (HasAxis(shape)) return RoundLines(shape);
  if (shape.kind() == v1::SHAPE_KIND_SPHERE && shape.has_center()) return BallLines(object);
  return EdgesOf(BlockOf(object.oriented_box()));
}

std::vector<SpaceLine> LinesOf(const v1::CollisionPrimitive& primitive) {
  v1::Object object;
  *object.mutable_oriented_box()->mutable_pose() = primitive.pose();
  *object.mutable_oriented_box()->mutable_size() = primitive.size();
  v1::Shape& shape = *object.mutable_shape();
  *shape.mutable_center() = primitive.pose().position();
  shape.set_radius_m(primitive.size().x() / 2);
  if (primitive.kind() == v1::COLLISION_KIND_SPHERE) shape.set_kind(v1::SHAPE_KIND_SPHERE);
  if (primitive.kind() == v1::COLLISION_KIND_CYLINDER) {
    shape.set_kind(v1::SHAPE_KIND_CYLINDER);
    shape.set_length_m(primitive.size().z());
    const cv::Vec3d axis = cv::normalize(BlockOf(object.oriented_box()).half_axes[2]);
    shape.mutable_axis()->set_x(axis[0]);
    shape.mutable_axis()->set_y(axis[1]);
    shape.mutable_axis()->set_z(axis[2]);
  }
  return LinesOf(object);
}

std::optional<SpaceLine> AxisOf(const v1::Object& object) {
  constexpr double kBeyond_m = 0.015;
  const v1::Shape& shape = object.shape();
  if (!HasAxis(shape)) return std::nullopt;
  const cv::Vec3d half = (shape.length_m() / 2 + kBeyond_m) * cv::normalize(ToVec(shape.axis()));
  return SpaceLine{ToVec(shape.center()) - half, ToVec(shape.center()) + half};
}

}  // namespace fovea::cli
