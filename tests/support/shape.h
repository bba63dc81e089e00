// Simple solids and where a ray meets them.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

namespace fovea::scenes {

enum class ShapeKind {
  kBox,
  kCylinder,  // axis z
  kSphere,
  kBowl,  // a piece of a spherical shell on a flat foot of half its radius, open towards +z
  kCup,   // a hollow cylinder, open towards +z
};

// A solid in its own frame: its bounding box is centred on the origin.
struct Shape {
  ShapeKind kind = ShapeKind::kBox;
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();  // full extents of the bounding box; x = y
                                                     // where the shape is round about z
  double wall_m = 0;                                 // of bowls and cups
};

// origin + t · direction for t > 0; the direction need not have unit length.
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;

  Eigen::Vector3d At(double t) const { return origin + t * direction; }
};

struct Hit {
  double t = 0;
  Eigen::Vector3d normal;  // unit vector, out of the solid
};

// The first point with 0 < t < max_t at which the ray enters the shape from outside; none if it
// misses, or starts within the material.
std::optional<Hit> Intersect(const Shape& shape, const Ray& ray,
                             double max_t = std::numeric_limits<double>::infinity());

// True for the shapes that are round about their z axis.
bool IsRound(ShapeKind kind);

}  // namespace fovea::scenes
