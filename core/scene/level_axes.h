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

}  // namespace fovea
