// Trees of merges of labelled scenes, and which of their nodes are objects.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/detector.h"
#include "core/objects/object_terms.h"
#include "core/options.h"
#include "core/segmentation/merge_tree.h"
#include "tests/evaluation/dataset.h"
#include "tests/evaluation/real_frames/boxed_frames.h"

namespace fovea::evaluation {

// Who a source is from: its name up to the first underscore. What one lab recorded is alike.
std::string GroupOf(const std::string& source);

// Whether a node is an object for all that the ground truth tells.
enum class NodeState { kIsNot, kMayBe, kIs };

struct TreeSample {
  MergeTree tree;
  std::vector<ObjectTerms> terms;  // of each node
  std::vector<NodeState> states;   // likewise
  double weight = 1;
  bool is_original = true;  // seen as the detector sees it by default
  std::string group;        // what is left out of a fit together
};

// Of each true object the node that overlaps it most is one, if their IoU is above 0.5: of masks
// where there are labels, of boxes where there are boxes. What is within or around it is not, but
// what is around it and overlaps it almost as much may be; so may what overlaps an optional object.
TreeSample SampleOf(const Scene& scene, const DetectorOptions& options);
TreeSample SampleOf(const BoxedFrame& frame, const DetectorOptions& options);

}  // namespace fovea::evaluation
