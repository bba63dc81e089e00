// What speaks for and against a segment, or a union of segments, being an object.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/objects/labelled_scene.h"
#include "core/objects/surroundings.h"
#include "core/segmentation/kinship.h"
#include "core/segmentation/merge_tree.h"
#include "core/segmentation/part.h"

namespace fovea {

// Where voxels are in relation to the surfaces that things stand on; sums and extremes.
struct Placement {
  int num_above = 0;    // voxels with a support below them
  int num_flat = 0;     // voxels that no height tells from a support
  int num_covered = 0;  // voxels that a support covers from above
  // Above the support below: the lowest and the highest voxel in metres, and the highest one as a
  // multiple of what may be noise there.
  float lowest_m = std::numeric_limits<float>::max();
  float highest_m = 0;
  float rise = 0;
  int num_level = 0;    // voxels that face up,
  int num_upright = 0;  // and to the side

  void Add(const Placement& other);
};

struct ObjectEvidence {
  Part part;
  Placement placement;
  BorderCounts borders;
  double num_pixels = 0;
  double num_missing = 0;  // pixels without depth, where a surface stands in
  cv::Rect bounds_px;
  int num_segments = 1;
  double inner_log_odds = 0;   // of the join that made it; 0 for one segment
  double outer_log_odds = 0;   // of the join that it is part of; MergeTree::min_log_odds for none
  KinshipTerms outer_terms{};  // of that join; 0 for none
  bool is_likely = false;      // the former speaks for it and the latter against more
};

// One entry a node of `tree`. `segments`: one entry a voxel, its labels. Cost: proportional to the
// image, and for n segments to n log n.
std::vector<ObjectEvidence> CollectEvidence(const LabelledScene& scene,
                                            const std::vector<int>& segments, const MergeTree& tree,
                                            const SupportOptions& support_options);

}  // namespace fovea
