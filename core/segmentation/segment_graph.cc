#include "core/segmentation/segment_graph.h"

#include <algorithm>
#include <utility>

#include "core/types/interruption.h"

namespace fovea {

SegmentGraph::SegmentGraph(const VoxelGrid& grid, const std::vector<int>& labels,
                           const std::vector<MeanColor>& colors, const CameraIntrinsics& intrinsics,
                           const Eigen::Vector3f& up)
    : parts_(CollectParts(grid, labels, colors, intrinsics, up)),
      neighbors_(parts_.size()),
      boundaries_(CollectBoundaries(grid, labels, colors, up)),
      objects_(static_cast<int>(parts_.size())) {
  for (const auto& [pair, boundary] : boundaries_) {
    neighbors_[pair.first].insert(pair.second);
    neighbors_[pair.second].insert(pair.first);
    UpdateKinship(pair);
  }
}

void SegmentGraph::Join(SegmentPair pair) {
  InterruptionPoint();
  const auto [into, from] = pair;
  objects_.Join(into, from);  // the smaller number stays
  parts_[into].Add(parts_[from]);
  for (const int other : std::exchange(neighbors_[from], {})) {
    const SegmentPair before = std::minmax(from, other);
    const Boundary boundary = boundaries_.at(before);
    boundaries_.erase(before);
    kinships_.erase(before);
    neighbors_[other].erase(from);
    if (other == into) continue;
    boundaries_[std::minmax(into, other)].Add(boundary);
    neighbors_[other].insert(into);
    neighbors_[into].insert(other);
  }
  for (const int other : neighbors_[into]) UpdateKinship(std::minmax(into, other));
}

void SegmentGraph::UpdateKinship(SegmentPair pair) {
  kinships_[pair] = KinshipOf(boundaries_.at(pair), parts_[pair.first], parts_[pair.second]);
}

}  // namespace fovea
