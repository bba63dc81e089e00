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

// Some positions side by side, for distances to all of them; keeps its memory.
class Positions {
 public:
  void Choose(const std::vector<Eigen::Vector3f>& positions, const std::vector<int>& indices) {
    for (std::vector<float>* column : {&x_, &y_, &z_, &squared_}) column->resize(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const Eigen::Vector3f& position = positions[indices[i]];
      x_[i] = position.x();
      y_[i] = position.y();
      z_[i] = position.z();
    }
  }

  std::size_t size() const { return x_.size(); }
  Eigen::Vector3f At(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }

  // One entry a position, summed in the order of squaredNorm(); until the next call.
  const std::vector<float>& SquaredDistances(const Eigen::Vector3f& from) {
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const float x = x_[i] - from.x(), y = y_[i] - from.y(), z = z_[i] - from.z();
      squared_[i] = x * x + (y * y + z * z);
    }
    return squared_;
  }

 private:
  std::vector<float> x_, y_, z_, squared_;
};

inline std::vector<Eigen::Vector3f> PositionsOf(const std::vector<Seed>& seeds) {
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(seeds.size());
  for (const Seed& seed : seeds) positions.push_back(seed.position);
  return positions;
}

}  // namespace fovea
