// Whether two segments lie on one plane, as far as the sensor's noise can tell.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

// First and second moments of the voxels of a segment, so that joined segments add up.
struct Spread {
  double num_voxels = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();             // of the voxels' means; metres
  Eigen::Matrix3d outer_products = Eigen::Matrix3d::Zero();  // sum over the voxels; square metres

  void Add(const Spread& other);
};

// One entry a label, the background's first. `labels`: one entry a voxel.
std::vector<Spread> SpreadOfSegments(const VoxelGrid& grid, const std::vector<int>& labels);

// True if both together are flat: the root mean square of their distances from the plane through
// them is below noise_per_m · z² at their mean distance z, and their extent within the plane is
// several times that; else small things would all be flat.
bool AreOnOnePlane(const Spread& a, const Spread& b, double noise_per_m);

}  // namespace fovea
