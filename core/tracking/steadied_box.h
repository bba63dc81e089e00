// The box of a thing that stands still, from several frames.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "core/types/oriented_box.h"

namespace fovea {

// The mean of the boxes of the last frames: of all of them up to kSteadiedOver, of more than those
// with weights that fall by 1 - 1 / kSteadiedOver from frame to frame. Boxes are turned about their
// upright axis by quarters until they are nearest to the mean, length and width changing places, as
// the longer side of a nearly square thing is a matter of noise.
class SteadiedBox {
 public:
  static constexpr std::uint32_t kSteadiedOver = 10;  // a second at ten answers a second

  explicit SteadiedBox(const OrientedBox& first) : mean_(first) {}

  void Add(const OrientedBox& box);
  // With this box alone, but for its turn.
  void StartAnew(const OrientedBox& box);
  // The frame of reference changes.
  void Transform(const Eigen::Isometry3f& to_from_own);

  const OrientedBox& mean() const { return mean_; }
  // The frames that count, 1 … kSteadiedOver.
  std::uint32_t count() const { return count_; }

 private:
  OrientedBox mean_;
  std::uint32_t count_ = 1;
};

}  // namespace fovea
