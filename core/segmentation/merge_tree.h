// The unions of segments that may be objects, one within the other.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/segmentation/segment_graph.h"

namespace fovea {

struct MergeNode {
  int left = -1, right = -1;  // what it joins; -1 for a segment
  int parent = -1;            // what it is joined to; -1 for none
  // The logarithm of the odds that left and right are one object, when they were joined.
  double log_odds = 0;
  Kinship kinship = {};  // of left and right then
};

// Node i < num_segments is the segment with label i + 1; a union comes after what it joins.
struct MergeTree {
  std::vector<MergeNode> nodes;
  std::size_t num_segments = 0;
  double min_log_odds = 0;     // of the joins that were looked for
  std::size_t num_likely = 0;  // nodes that were made while that was more likely than not

  // The nodes that were not joined any further while that was more likely than not.
  std::vector<int> LikelyNodes() const;
};

// Joins the pair of touching segments that are most likely one object (LogOdds in kinship.h), again
// and again, until no pair has more than `min_log_odds`; what is known of joined segments is summed
// up. Once no pair is more likely one object than two, those that do not touch but are one object
// all the same are joined: `find_separate` takes the label of the object of each voxel so far and
// gives the new ones. `labels`: one entry a voxel, 0 = background.
using FindSeparate = std::function<std::vector<int>(const std::vector<int>&)>;
MergeTree BuildMergeTree(SegmentGraph graph, const std::vector<int>& labels, double min_log_odds,
                         const FindSeparate& find_separate);

}  // namespace fovea
