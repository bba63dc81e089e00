// Simple solids that stand, or lie, on a level plane, and how far points are from their surface.
// Oblongs stand: their footprint is a rectangle whose short sides are half circles. Bent rods lie
// and have round ends.
//
// Level frame: x and y along the plane, h above it; metres.
#pragma once

#include <Eigen/Core>
#include <stdexcept>

namespace fovea {

// Numbers of what was seen of one object, and of what a solid of one has as parameters: few, so
// that they need no memory of their own.
inline constexpr int kMaxSeen = 256, kMaxParameters = 6;
using SeenArray = Eigen::Array<float, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxSeen, 1>;
using ParameterVector = Eigen::Matrix<float, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxParameters, 1>;
using ParameterMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                      kMaxParameters, kMaxParameters>;

struct LevelPoints {
  SeenArray x, y, h;

  // Throws std::length_error for more than kMaxSeen.
  explicit LevelPoints(Eigen::Index size = 0) {
    if (size > kMaxSeen) throw std::length_error("points of a solid: more than kMaxSeen");
    x.resize(size);
    y.resize(size);
    h.resize(size);
  }
  Eigen::Index size() const { return x.size(); }
};

struct Solid {
  enum class Kind { kBox, kUprightCylinder, kLyingCylinder, kSphere, kFrustum, kOblong, kBent };
  Kind kind = Kind::kBox;
  Eigen::Vector2f center = Eigen::Vector2f::Zero();  // on the plane, of the footprint
  Eigen::Vector2f along = Eigen::Vector2f::UnitX();  // of what has a turn: unit vector
  float half_length_m = 0;                           // along it
  float half_width_m = 0;                            // of boxes and oblongs
  float height_m = 0;                                // of what stands
  float radius_m = 0;                                // of all round ones; of frusta at the top
  float bottom_radius_m = 0;                         // of frusta
  float bulge_m = 0;  // of frusta: how far the wall stands out half way up; a parabola
  float bend_m = 0;   // of bent rods: how far the ends of the axis lie to the left of `along` from
                      // its middle; a parabola

  // Of upright cylinders and frusta, at a share of the height.
  float RadiusAt(float share) const;

  // The largest radius of what is round.
  float WidestRadius() const;

  // Its extents along `along`, across it and upwards.
  Eigen::Vector3f Size() const;
};

// How many numbers describe a solid of this kind: its centre, its turn where it has one, its sizes.
int NumParameters(Solid::Kind kind);

// Whether a turn is one of them, and which.
bool HasTurn(Solid::Kind kind);
inline constexpr int kTurnParameter = 2;

// Changed by a step in these numbers. A turn is in radians, for small ones. Sizes stay above 2 mm.
Solid Moved(const Solid& solid, const ParameterVector& step);

// Distances from the surface, negative inside; of frusta to first order in how far the wall leans.
// With a camera, inside of a box the distance is that from the faces that the camera sees: what is
// measured has come through none of the others.
void SignedDistances(const Solid& solid, const LevelPoints& points, SeenArray& distances,
                     const Eigen::Vector3f* camera = nullptr);

// Of what is hollow, an upright cylinder or a frustum, with walls and a bottom that thick:
// distances from the nearer of the inner wall and the bottom, without a sign.
SeenArray DistancesInside(const Solid& solid, const LevelPoints& points, float wall_m);

}  // namespace fovea
