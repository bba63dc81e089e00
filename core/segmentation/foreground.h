// The voxels that are not background, and places by which to look for those near a seed.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/segmentation/voxel_grid.h"
#include "core/types/detections.h"

namespace fovea {

struct Foreground {
  std::vector<int> voxels;
  std::vector<Eigen::Vector3f> means;
};

inline Foreground CollectForeground(const VoxelGrid& grid, const std::vector<char>& is_background) {
  Foreground foreground;
  for (int v = 0; v < static_cast<int>(is_background.size()); ++v) {
    if (is_background[v]) continue;
    foreground.voxels.push_back(v);
    foreground.means.push_back(grid.voxels[v].mean);
  }
  return foreground;
}

using Positions = Eigen::Array<float, Eigen::Dynamic, 3>;  // a row each

inline Positions Chosen(const std::vector<Eigen::Vector3f>& positions,
                        const std::vector<int>& indices) {
  Positions chosen(static_cast<Eigen::Index>(indices.size()), 3);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    chosen.row(static_cast<Eigen::Index>(i)) = positions[indices[i]].array().transpose();
  }
  return chosen;
}

inline std::vector<Eigen::Vector3f> PositionsOf(const std::vector<Seed>& seeds) {
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(seeds.size());
  for (const Seed& seed : seeds) positions.push_back(seed.position);
  return positions;
}

// To each position, summed in the order of squaredNorm().
inline auto SquaredDistances(const Positions& positions, const Eigen::Vector3f& from) {
  return (positions.col(0) - from.x()).square() +
         ((positions.col(1) - from.y()).square() + (positions.col(2) - from.z()).square());
}

}  // namespace fovea
