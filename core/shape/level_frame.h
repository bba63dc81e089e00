// Where an object stands, as a frame.
#pragma once

#include <Eigen/Core>

#include "core/types/detections.h"

namespace fovea {

// A level frame: its plane carries the object. Columns of `rotation` are its axes in the camera
// frame; the third is up.
struct LevelFrame {
  Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();

  Eigen::Vector3f FromCamera(const Eigen::Vector3f& p) const {
    return rotation.transpose() * (p - origin);
  }
  Eigen::Vector3f ToCamera(const Eigen::Vector3f& p) const { return origin + rotation * p; }
};

// That of a box, whose footprint is centred on its origin, with its axes.
inline LevelFrame FrameUnder(const OrientedBox& box) {
  return {box.rotation, box.center - box.rotation.col(2) * (box.size_m.z() / 2)};
}

}  // namespace fovea
