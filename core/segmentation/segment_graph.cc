#include "core/segmentation/segment_graph.h"

#include <algorithm>

namespace fovea {

SegmentGraph::SegmentGraph(const VoxelGrid& grid, const std::vector<int>& labels,
                           const std::vector<MeanColor>& colors, const CameraIntrinsics& intrinsics,
                           const Eigen::Vector3f& up)
    : parts_(CollectParts(grid, labels, colors, intrinsics, up)),
      boundaries_(CollectBoundaries(grid, labels, colors)),
      objects_(static_cast<int>(parts_.size())) {
  for (const auto& [pair, boundary] : boundaries_) {
    kinships_[pair] = KinshipOf(boundary, parts_[pair.first], parts_[pair.second]);
  }
}

void SegmentGraph::Join(SegmentPair pair) {
  const auto [into, from] = pair;
  objects_.Join(into, from);  // the smaller number stays
  parts_[into].Add(parts_[from]);
  boundaries_.erase(pair);
  kinships_.erase(pair);
  Boundaries moved;
  for (auto it = boundaries_.begin(); it != boundaries_.end();) {
    const auto [low, high] = it->first;
    if (low != from && high != from) {
      ++it;
      continue;
    }
    moved[std::minmax(into, int{low == from ? high : low})].Add(it->second);
    kinships_.erase(it->first);
    it = boundaries_.erase(it);
  }
  for (const auto& [moved_pair, boundary] : moved) boundaries_[moved_pair].Add(boundary);
  UpdateKinships(into);
}

void SegmentGraph::UpdateKinships(int label) {
  for (const auto& [pair, boundary] : boundaries_) {
    if (pair.first != label && pair.second != label) continue;
    kinships_[pair] = KinshipOf(boundary, parts_[pair.first], parts_[pair.second]);
  }
}

}  // namespace fovea
