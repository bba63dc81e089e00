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

// A place seen from the middle of a solid, along and across its turn.
class PlacesAround {
 public:
  explicit PlacesAround(const Solid& solid) : center_(solid.center), along_(solid.along) {}

  FOVEA_INLINE float Along(float x, float y) const {
    return along_.x() * (x - center_.x()) + along_.y() * (y - center_.y());
  }
  FOVEA_INLINE float Across(float x, float y) const {
    return along_.x() * (y - center_.y()) - along_.y() * (x - center_.x());
  }
  FOVEA_INLINE float SquaredFromAxis(float x, float y) const {
    return Squared(x - center_.x()) + Squared(y - center_.y());
  }
  FOVEA_INLINE float FromAxis(float x, float y) const { return std::sqrt(SquaredFromAxis(x, y)); }

 private:
  Eigen::Vector2f center_, along_;
};

class DistanceOfBox {
 public:
  explicit DistanceOfBox(const Solid& solid)
      : places_(solid),
        half_length_m_(solid.half_length_m),
        half_width_m_(solid.half_width_m),
        height_m_(solid.height_m) {}

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    const float u = std::abs(places_.Along(x, y)) - half_length_m_;
    const float v = std::abs(places_.Across(x, y)) - half_width_m_;
    const float w = DistanceOfLayer(h, height_m_);
    return Beyond(u, v, w) + std::min(std::max(std::max(u, v), w), 0.0F);
  }

 private:
  PlacesAround places_;
  float half_length_m_, half_width_m_, height_m_;
};

// Inside, from the faces that the camera sees.
class DistanceOfSeenBox {
 public:
  DistanceOfSeenBox(const Solid& solid, const Eigen::Vector3f& camera)
      : places_(solid),
        half_length_m_(solid.half_length_m),
        half_width_m_(solid.half_width_m),
        height_m_(solid.height_m),
        lengthwise_(places_.Along(camera.x(), camera.y()), half_length_m_),
        crosswise_(places_.Across(camera.x(), camera.y()), half_width_m_),
        upwards_(camera.z() - height_m_ / 2, height_m_ / 2) {}

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    const float along = places_.Along(x, y), across = places_.Across(x, y);
    const float u = std::abs(along) - half_length_m_, v = std::abs(across) - half_width_m_;
    const float w = DistanceOfLayer(h, height_m_);
    const float behind = std::max(std::max(lengthwise_.Behind(along), crosswise_.Behind(across)),
                                  upwards_.Behind(h - height_m_ / 2));
    return Beyond(u, v, w) + std::min(behind, 0.0F);
  }

 private:
  // Of the faces at -half and half the one that the camera sees.
  struct SeenFace {
    SeenFace(float camera, float half)
        : sign(std::abs(camera) <= half ? 0.0F
               : camera > 0             ? 1.0F
                                        : -1.0F),
          half_m(sign == 0 ? 1 : half) {}

    // Negative before it; far inside where the camera sees neither.
    FOVEA_INLINE float Behind(float place) const { return sign * place - half_m; }

    float sign, half_m;
  };

  PlacesAround places_;
  float half_length_m_, half_width_m_, height_m_;
  SeenFace lengthwise_, crosswise_, upwards_;
};

class DistanceOfUprightCylinder {
 public:
  explicit DistanceOfUprightCylinder(const Solid& solid)
      : places_(solid), radius_m_(solid.radius_m), height_m_(solid.height_m) {}

  FOVEA_INLINE float FromWall(float x, float y, float /*h*/) const {
    return places_.FromAxis(x, y) - radius_m_;
  }
  FOVEA_INLINE float operator()(float x, float y, float h) const {
    return DistanceOfProduct(FromWall(x, y, h), DistanceOfLayer(h, height_m_));
  }

 private:
  PlacesAround places_;
  float radius_m_, height_m_;
};

// To first order in how far the wall leans.
class DistanceOfFrustum {
 public:
  explicit DistanceOfFrustum(const Solid& solid)
      : places_(solid),
        bottom_radius_m_(solid.bottom_radius_m),
        widens_m_(solid.radius_m - solid.bottom_radius_m),
        bulge_m_(solid.bulge_m),
        height_m_(solid.height_m) {}

  FOVEA_INLINE float FromWall(float x, float y, float h) const {
    const float share = std::min(std::max(h, 0.0F), height_m_) / height_m_;
    const float radius = bottom_radius_m_ + share * (widens_m_ + 4 * bulge_m_ * (1 - share));
    const float slope = (widens_m_ + 4 * bulge_m_ * (1 - 2 * share)) / height_m_;
    return (places_.FromAxis(x, y) - radius) / std::sqrt(1 + Squared(slope));
  }
  FOVEA_INLINE float operator()(float x, float y, float h) const {
    return DistanceOfProduct(FromWall(x, y, h), DistanceOfLayer(h, height_m_));
  }

 private:
  PlacesAround places_;
  float bottom_radius_m_, widens_m_, bulge_m_, height_m_;
};

class DistanceOfLyingCylinder {
 public:
  explicit DistanceOfLyingCylinder(const Solid& solid)
      : places_(solid), half_length_m_(solid.half_length_m), radius_m_(solid.radius_m) {}

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    const float wall =
        std::sqrt(Squared(places_.Across(x, y)) + Squared(h - radius_m_)) - radius_m_;
    return DistanceOfProduct(wall, std::abs(places_.Along(x, y)) - half_length_m_);
  }

 private:
  PlacesAround places_;
  float half_length_m_, radius_m_;
};

class DistanceOfSphere {
 public:
  explicit DistanceOfSphere(const Solid& solid) : places_(solid), radius_m_(solid.radius_m) {}

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    return std::sqrt(places_.SquaredFromAxis(x, y) + Squared(h - radius_m_)) - radius_m_;
  }

 private:
  PlacesAround places_;
  float radius_m_;
};

class DistanceOfOblong {
 public:
  explicit DistanceOfOblong(const Solid& solid)
      : places_(solid),
        straight_m_(solid.half_length_m - solid.half_width_m),
        half_width_m_(solid.half_width_m),
        height_m_(solid.height_m) {}

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    const float beyond = std::max(std::abs(places_.Along(x, y)) - straight_m_, 0.0F);
    const float wall = std::sqrt(Squared(beyond) + Squared(places_.Across(x, y))) - half_width_m_;
    return DistanceOfProduct(wall, DistanceOfLayer(h, height_m_));
  }

 private:
  PlacesAround places_;
  float straight_m_, half_width_m_, height_m_;
};

// To first order in the bend.
class DistanceOfBent {
 public:
  explicit DistanceOfBent(const Solid& solid)
      : places_(solid),
        reach_m_(solid.half_length_m - solid.radius_m),
        bend_m_(solid.bend_m),
        radius_m_(solid.radius_m) {}

  FOVEA_INLINE float operator()(float x, float y, float h) const {
    const float along = places_.Along(x, y);
    const float share = std::min(std::max(along / reach_m_, -1.0F), 1.0F);
    const float slope = 2 * bend_m_ / reach_m_ * share;
    const float across = places_.Across(x, y) - bend_m_ * (Squared(share) - 0.5F);
    const float beyond = along - share * reach_m_;
    return std::sqrt(Squared(beyond) + Squared(across) / (1 + Squared(slope)) +
                     Squared(h - radius_m_)) -
           radius_m_;
  }

 private:
  PlacesAround places_;
  float reach_m_, bend_m_, radius_m_;
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
