// How far a point is from each kind of solid, as functions that loops over points and rays have
// inlined; SignedDistances (solid.h) says what they compute. Negative inside. x, y and h of the
// level frame, metres.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/shape/solid.h"
#include "core/types/widest_registers.h"

namespace fovea {

FOVEA_INLINE float Squared(float value) { return value * value; }

// From three faces of a box, of which those that are behind do not count.
FOVEA_INLINE float Beyond(float u, float v, float w) {
  return std::sqrt(Squared(std::max(u, 0.0F)) + Squared(std::max(v, 0.0F)) +
                   Squared(std::max(w, 0.0F)));
}

// Of what is the product of two shapes, from the distances to both.
FOVEA_INLINE float DistanceOfProduct(float a, float b) {
  const float beyond = std::sqrt(Squared(std::max(a, 0.0F)) + Squared(std::max(b, 0.0F)));
  return beyond + std::min(std::max(a, b), 0.0F);
}

// To the layer between the plane and `height_m`.
FOVEA_INLINE float DistanceOfLayer(float h, float height_m) {
  return std::abs(h - height_m / 2) - height_m / 2;
}

// A solid, and places seen from its middle, along and across its turn.
class SolidAround {
 public:
  explicit SolidAround(const Solid& solid) : solid_(solid) {}

 protected:
  FOVEA_INLINE float Along(float x, float y) const {
    return solid_.along.x() * (x - solid_.center.x()) + solid_.along.y() * (y - solid_.center.y());
  }
  FOVEA_INLINE float Across(float x, float y) const {
    return solid_.along.x() * (y - solid_.center.y()) - solid_.along.y() * (x - solid_.center.x());
  }
  FOVEA_INLINE float SquaredFromAxis(float x, float y) const {
    return Squared(x - solid_.center.x()) + Squared(y - solid_.center.y());
  }
  FOVEA_INLINE float FromAxis(float x, float y) const { return std::sqrt(SquaredFromAxis(x, y)); }

  Solid solid_;
};

class DistanceOfBox : SolidAround {
 public:
  using SolidAround::SolidAround;

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    const float u = std::abs(Along(x, y)) - solid_.half_length_m;
    const float v = std::abs(Across(x, y)) - solid_.half_width_m;
    const float w = DistanceOfLayer(h, solid_.height_m);
    return Beyond(u, v, w) + std::min(std::max(std::max(u, v), w), 0.0F);
  }
};

// Inside, from the faces that the camera sees.
class DistanceOfSeenBox : SolidAround {
 public:
  DistanceOfSeenBox(const Solid& solid, const Eigen::Vector3f& camera)
      : SolidAround(solid),
        lengthwise_(Along(camera.x(), camera.y()), solid.half_length_m),
        crosswise_(Across(camera.x(), camera.y()), solid.half_width_m),
        upwards_(camera.z() - solid.height_m / 2, solid.height_m / 2) {}

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    const float along = Along(x, y), across = Across(x, y);
    const float u = std::abs(along) - solid_.half_length_m;
    const float v = std::abs(across) - solid_.half_width_m;
    const float w = DistanceOfLayer(h, solid_.height_m);
    const float behind = std::max(std::max(lengthwise_.Behind(along), crosswise_.Behind(across)),
                                  upwards_.Behind(h - solid_.height_m / 2));
    return Beyond(u, v, w) + std::min(behind, 0.0F);
  }

 private:
  // Of the faces at -half and half the one that the camera sees.
  struct SeenFace {
    SeenFace(float camera, float half)
        : sign(std::abs(camera) <= half ? 0.0F : std::copysign(1.0F, camera)),
          half_m(sign == 0 ? 1 : half) {}

    // Negative before it; far inside where the camera sees neither.
    FOVEA_INLINE float Behind(float place) const { return sign * place - half_m; }

    float sign, half_m;
  };

  SeenFace lengthwise_, crosswise_, upwards_;
};

class DistanceOfUprightCylinder : SolidAround {
 public:
  using SolidAround::SolidAround;

  FOVEA_INLINE float FromWall(float x, float y, float /*h*/) const {
    return FromAxis(x, y) - solid_.radius_m;
  }
  FOVEA_INLINE float operator()(float x, float y, float h) const {
    return DistanceOfProduct(FromWall(x, y, h), DistanceOfLayer(h, solid_.height_m));
  }
};

// To first order in how far the wall leans.
class DistanceOfFrustum : SolidAround {
 public:
  using SolidAround::SolidAround;

  FOVEA_INLINE float FromWall(float x, float y, float h) const {
    const float widens = solid_.radius_m - solid_.bottom_radius_m;
    const float share = std::min(std::max(h, 0.0F), solid_.height_m) / solid_.height_m;
    const float radius =
        solid_.bottom_radius_m + share * (widens + 4 * solid_.bulge_m * (1 - share));
    const float slope = (widens + 4 * solid_.bulge_m * (1 - 2 * share)) / solid_.height_m;
    return (FromAxis(x, y) - radius) / std::sqrt(1 + Squared(slope));
  }
  FOVEA_INLINE float operator()(float x, float y, float h) const {
    return DistanceOfProduct(FromWall(x, y, h), DistanceOfLayer(h, solid_.height_m));
  }
};

class DistanceOfLyingCylinder : SolidAround {
 public:
  using SolidAround::SolidAround;

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    const float from_axis = std::sqrt(Squared(Across(x, y)) + Squared(h - solid_.radius_m));
    return DistanceOfProduct(from_axis - solid_.radius_m,
                             std::abs(Along(x, y)) - solid_.half_length_m);
  }
};

class DistanceOfSphere : SolidAround {
 public:
  using SolidAround::SolidAround;

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    return std::sqrt(SquaredFromAxis(x, y) + Squared(h - solid_.radius_m)) - solid_.radius_m;
  }
};

class DistanceOfOblong : SolidAround {
 public:
  using SolidAround::SolidAround;

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    const float straight = solid_.half_length_m - solid_.half_width_m;
    const float beyond = std::max(std::abs(Along(x, y)) - straight, 0.0F);
    const float from_middle = std::sqrt(Squared(beyond) + Squared(Across(x, y)));
    return DistanceOfProduct(from_middle - solid_.half_width_m,
                             DistanceOfLayer(h, solid_.height_m));
  }
};

// To first order in the bend.
class DistanceOfBent : SolidAround {
 public:
  using SolidAround::SolidAround;

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    const float reach = solid_.half_length_m - solid_.radius_m;
    const float along = Along(x, y);
    const float share = std::min(std::max(along / reach, -1.0F), 1.0F);
    const float slope = 2 * solid_.bend_m / reach * share;
    const float across = Across(x, y) - solid_.bend_m * (Squared(share) - 0.5F);
    const float beyond = along - share * reach;
    return std::sqrt(Squared(beyond) + Squared(across) / (1 + Squared(slope)) +
                     Squared(h - solid_.radius_m)) -
           solid_.radius_m;
  }
};

// Calls `use` with the distance from this solid, of whichever kind it is.
template <typename Use>
void WithDistanceFrom(const Solid& solid, const Use& use) {
  switch (solid.kind) {
    case Solid::Kind::kBox:
      return use(DistanceOfBox(solid));
    case Solid::Kind::kUprightCylinder:
      return use(DistanceOfUprightCylinder(solid));
    case Solid::Kind::kLyingCylinder:
      return use(DistanceOfLyingCylinder(solid));
    case Solid::Kind::kSphere:
      return use(DistanceOfSphere(solid));
    case Solid::Kind::kFrustum:
      return use(DistanceOfFrustum(solid));
    case Solid::Kind::kOblong:
      return use(DistanceOfOblong(solid));
    case Solid::Kind::kBent:
      return use(DistanceOfBent(solid));
  }
}

}  // namespace fovea
