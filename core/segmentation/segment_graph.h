// Touching segments, to be joined pair by pair.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "core/segmentation/boundary.h"
#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/kinship.h"
#include "core/segmentation/part.h"

namespace fovea {

class SegmentGraph {
 public:
  // `labels`, `colors`: one entry a voxel; the background, 0, takes no part. `up`: unit vector.
  SegmentGraph(const VoxelGrid& grid, const std::vector<int>& labels,
               const std::vector<MeanColor>& colors, const CameraIntrinsics& intrinsics,
               const Eigen::Vector3f& up);

  // The segments that touch; a joined one goes by its lowest label.
  const std::map<SegmentPair, Kinship>& Pairs() const { return kinships_; }

  // The segments of each joined one, under its lowest label.
  DisjointSets& Objects() { return objects_; }

  // The segments that touch one.
  const std::set<int>& NeighborsOf(int segment) const { return neighbors_[segment]; }

  // Makes a pair one segment. Cost: proportional to the neighbours of both.
  void Join(SegmentPair pair);

 private:
  void UpdateKinship(SegmentPair pair);

  std::vector<Part> parts_;
  std::vector<std::set<int>> neighbors_;
  Boundaries boundaries_;
  std::map<SegmentPair, Kinship> kinships_;
  DisjointSets objects_;
};

}  // namespace fovea
