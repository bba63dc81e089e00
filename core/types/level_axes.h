// Axes of a level plane.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fovea {

// Two unit vectors at right angles, as rows: what they take a point to is its place on the plane.
using LevelAxes = Eigen::Matrix<float, 2, 3>;

// With `up`, a unit vector, as the third axis they make a right-handed frame.
inline LevelAxes LevelAxesFor(const Eigen::Vector3f& up) {
  LevelAxes axes;
  axes.row(0) = up.unitOrthogonal();
  axes.row(1) = up.cross(axes.row(0).transpose());
  return axes;
}

// The same, of which the first leads to the right and the second away from the camera; to the upper
// border of the image where the camera looks straight down or up.
inline LevelAxes LevelAxesAlongView(const Eigen::Vector3f& up) {
  constexpr float kMinLevel = 0.1F;  // of the optical axis
  const auto level = [&up](const Eigen::Vector3f& way) -> Eigen::Vector3f {
    return way - up * up.dot(way);
  };
  Eigen::Vector3f away = level(Eigen::Vector3f::UnitZ());
  if (away.norm() < kMinLevel) away = level(-Eigen::Vector3f::UnitY());
  away.normalize();
  LevelAxes axes;
  axes << away.cross(up).transpose(), away.transpose();
  return axes;
}

}  // namespace fovea
