// Simple solids and where a ray meets them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace fovea::scenes {

enum class ShapeKind {
  kBox,
  kCylinder,  // axis z
  kSphere,
  kBowl,      // a piece of a spherical shell on a flat foot of half its radius, open towards +z
  kCup,       // a hollow cylinder, open towards +z
  kCushion,   // flat below, its upper side uneven: bags, folded and crumpled cloth
  kCompound,  // the union of its parts
};

struct Part;

// The upper side of a cushion.
struct Relief {
  double fullness = 2;    // 1 = falls from the middle to the sides, large = at the sides only
  double depth_m = 0;     // of its dents and creases
  double scale_m = 0.05;  // across a dent
  std::uint32_t seed = 0;
};

// A solid in its own frame: its bounding box is centred on the origin.
struct Shape {
  ShapeKind kind = ShapeKind::kBox;
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();  // full extents of the bounding box; x = y
                                                     // where the shape is round about z
  double wall_m = 0;                                 // of bowls and cups
  std::vector<Part> parts;                           // of compounds, else none
  Relief relief = {};                                // of cushions
};

// One of the solids of a compound.
struct Part {
  Shape shape;
  Eigen::Isometry3d shape_from_part = Eigen::Isometry3d::Identity();
  int material = 0;  // 0 = the body's own, k = its k-th other one
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
  int material = 0;        // as Part::material
};

// The first point with 0 < t < max_t at which the ray enters the shape from outside; none if it
// misses, or starts within the material. A ray that starts within one part of a compound may still
// enter another.
std::optional<Hit> Intersect(const Shape& shape, const Ray& ray,
                             double max_t = std::numeric_limits<double>::infinity());

// The compound of parts given in any frame: moved so that their bounding box, which becomes its
// size, is centred on the origin. The box is exact for parts that are simple and, where round
// about an axis, as wide at both ends.
Shape CompoundOf(std::vector<Part> parts);

// True for the shapes that are round about their z axis.
bool IsRound(ShapeKind kind);

}  // namespace fovea::scenes
