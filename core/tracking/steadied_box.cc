#include "core/tracking/steadied_box.h"

#include <algorithm>
#include <utility>

#include "core/tracking/sighting.h"

namespace fovea {
namespace {

OrientedBox QuarterTurned(const OrientedBox& box) {
  OrientedBox turned = box;
  turned.rotation.col(0) = box.rotation.col(1);
  turned.rotation.col(1) = -box.rotation.col(0);
  std::swap(turned.size_m.x(), turned.size_m.y());
  return turned;
}

// Of the four boxes that look the same, the one whose axes are nearest.
OrientedBox NearestTurn(OrientedBox box, const Eigen::Matrix3f& rotation) {
  const auto likeness = [&](const OrientedBox& turned) {
    return (rotation.transpose() * turned.rotation).trace();  // 1 + 2 cos of the angle between
  };
  OrientedBox best = box;
  for (int quarter = 1; quarter < 4; ++quarter) {
    box = QuarterTurned(box);
    if (likeness(box) > likeness(best)) best = box;
  }
  return best;
}

}  // namespace

void SteadiedBox::Add(const OrientedBox& box) {
  count_ = std::min(count_ + 1, kSteadiedOver);
  const float weight = 1.0F / static_cast<float>(count_);
  const OrientedBox turned = NearestTurn(box, mean_.rotation);
  mean_.center += weight * (turned.center - mean_.center);
  mean_.size_m += weight * (turned.size_m - mean_.size_m);
  mean_.rotation = Eigen::Quaternionf(mean_.rotation)
                       .slerp(weight, Eigen::Quaternionf(turned.rotation))
                       .normalized()
                       .toRotationMatrix();
}

void SteadiedBox::StartAnew(const OrientedBox& box) {
  count_ = 1;
  mean_ = NearestTurn(box, mean_.rotation);
}

void SteadiedBox::Transform(const Eigen::Isometry3f& to_from_own) {
  mean_ = Moved(mean_, to_from_own);
}

}  // namespace fovea
