// What may carry an object: another one below it that does not rest on it, or its support. Object k
// has label k.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/shape/outline.h"
#include "core/types/detections.h"

namespace fovea {

constexpr float kContact_m = 0.02F;  // between a thing and what it stands on, as measured

struct Carrier {
  int label = 0;     // 0: a support
  float drop_m = 0;  // how far below the lowest point of the object that was seen
};

// The height of a box's bottom (`share` 0), top (1) or what is between, against gravity.
float HeightAlong(const Eigen::Vector3f& up, const OrientedBox& box, float share);

// Of the object's lowest point that was seen.
float HeightAboveSupport(const DetectedObject& object, const SupportSurface& support);

struct Touch {
  bool is_seen = false;        // else the object is seen to end in the air
  std::optional<int> carrier;  // 0: the support; nothing: what is seen there carries nothing
};

// What touches the object from below: where it ends, something at the height of its lowest points
// is seen beyond. Most of it is of the carrier: an object that ends there, or the support. What is
// neither stands beside it, or is of the object itself.
Touch Touching(const DetectedObject& object, const std::vector<DetectedObject>& others,
               const std::vector<OutlinePoint>& outline,
               const std::optional<SupportSurface>& support);

// The highest of the objects below that it is balanced on, or may lie across, then the support.
// `lower`: those of `others` whose tops are lower than the object's, with completed boxes and
// shapes.
std::vector<Carrier> CarriersOf(const DetectedObject& object,
                                const std::vector<DetectedObject>& others,
                                const std::vector<std::size_t>& lower,
                                const std::optional<SupportSurface>& support);

// Nothing stays in the air: what is high above its support, and explained by a solid (`box`) that
// nothing touches from below, stands on that of the lower objects whose footprint it shares most
// of, if of any. Returns its label.
std::optional<int> HeldBy(const DetectedObject& object, const std::vector<DetectedObject>& others,
                          const std::vector<std::size_t>& lower,
                          const std::optional<SupportSurface>& support);

}  // namespace fovea
