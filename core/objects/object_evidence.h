// What speaks for and against a segment, or a union of segments, being an object.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/objects/labelled_scene.h"
#include "core/objects/surroundings.h"
#include "core/segmentation/kinship.h"
#include "core/segmentation/merge_tree.h"
#include "core/segmentation/part.h"

namespace fovea {

// Numbers of voxels by where they are in relation to the surfaces that things stand on.
struct Placement {
  int num_flat = 0;   // no height tells them from a support
  int num_level = 0;  // they face up

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
  double outer_log_odds = 0;   // of the join that it is part of; MergeTree::min_log_odds for none
  KinshipTerms outer_terms{};  // of that join; 0 for none
};

// What can be said of segments however they are joined.
struct SegmentEvidence {
  std::vector<ObjectEvidence> of_segments;  // of label i + 1, without joins
  std::vector<Facing> facings;              // between them
};

// `segments`: one entry a voxel, its labels. Cost: proportional to the image.
SegmentEvidence LookAtSegments(const LabelledScene& scene, const std::vector<int>& segments,
                               const SupportOptions& support_options);

// One entry a node of `tree`, which is of the same segments. Cost: for n segments and facings
// proportional to n log n.
std::vector<ObjectEvidence> CollectEvidence(SegmentEvidence segments, const MergeTree& tree);

}  // namespace fovea
