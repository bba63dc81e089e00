// How a segment bends about the vertical: an upright cylinder that follows it.
#pragma once

#include <Eigen/Core>
#include <span>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

struct Roundness {
  // Mean change of the normals along the segment: 1/radius of a cylinder seen from outside,
  // −1/radius from inside, less where the wall is inclined, 0 for a plane. By linear regression, so
  // that noise of the normals does not enlarge it.
  double curvature_per_m = 0;
  // The spread of the places over that of the directions in which they face, which inclined walls
  // and smoothed normals falsify less; 0 where all face one way.
  double radius_m = 0;
  Eigen::Vector3f axis = Eigen::Vector3f::Zero();  // a point on it; in the plane through the origin
};

// `voxels`: those of the segment, with normals; `up`: unit vector.
Roundness FitRoundness(const VoxelGrid& grid, std::span<const int> voxels,
                       const Eigen::Vector3f& up);

// Mean cosine between the normals of the voxels and the way to them from an axis, both in the
// horizontal plane: 1 for the outside of something round about that axis, −1 for its inside, 0
// where no normal has a direction there.
double MeanFacing(const VoxelGrid& grid, std::span<const int> voxels, const Eigen::Vector3f& axis,
                  const Eigen::Vector3f& up);

// The part of `v` at right angles to `up`.
inline Eigen::Vector3f Horizontal(const Eigen::Vector3f& v, const Eigen::Vector3f& up) {
  return v - up.dot(v) * up;
}

}  // namespace fovea
