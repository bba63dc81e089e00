// From labelled voxels to objects (paper section 3.3, and beyond it).
#pragma once

#include <vector>

#include "core/objects/labelled_scene.h"
#include "core/objects/object_evidence.h"
#include "core/options.h"
#include "core/segmentation/merge_tree.h"
#include "core/types/detections.h"

namespace fovea {

struct RefinedScene {
  std::vector<int> segments;  // one entry a voxel, connected parts of the labels; 0 = background
  MergeTree tree;             // of the segments
  std::vector<ObjectEvidence> evidence;  // of the nodes of the tree
  std::vector<int> objects;              // one entry a voxel: 1 … n, 0 = background
  std::vector<float> confidences;        // of object k at k − 1: the probability that it is one
  std::size_t num_merged = 0;            // segments that were joined to another in an object
  std::vector<RejectedObject> rejected;
};

// Splits the labels into connected segments, joins them to a tree of unions that may be objects,
// collects what speaks for and against each, and chooses those that most likely are. Throws
// TooComplex for more than 65535 segments.
RefinedScene Refine(const LabelledScene& scene, const DetectorOptions& options);

}  // namespace fovea
