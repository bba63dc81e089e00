// The neighbours of each voxel.
#pragma once

#include <span>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

class Adjacency {
 public:
  explicit Adjacency(const VoxelGrid& grid) : first_(grid.voxels.size() + 1, 0) {
    for (const VoxelEdge& edge : grid.edges) {
      ++first_[edge.a + 1];
      ++first_[edge.b + 1];
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    neighbors_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (const VoxelEdge& edge : grid.edges) {
      neighbors_[next[edge.a]++] = edge.b;
      neighbors_[next[edge.b]++] = edge.a;
    }
  }

  std::span<const int> NeighborsOf(int voxel) const {
    return {neighbors_.data() + first_[voxel],
            static_cast<std::size_t>(first_[voxel + 1] - first_[voxel])};
  }

 private:
  std::vector<int> first_;  // of each voxel in neighbors_; one more at the end
  std::vector<int> neighbors_;
};

}  // namespace fovea
