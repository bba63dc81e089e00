// What a caller may want to see of the steps between a frame and its objects.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/grasping/grasp_terms.h"
#include "core/objects/object_evidence.h"
#include "core/segmentation/mean_color.h"
#include "core/segmentation/merge_tree.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/detections.h"

namespace fovea {

struct Trace {
  cv::Mat depth_m;                   // CV_32FC1 after hole filling, NaN = none, frame size
  cv::Mat color_saliency;            // CV_32FC1 in [0, 1], frame size
  cv::Mat depth_saliency;            // CV_32FC1 in [0, 1], frame size
  std::vector<Seed> seeds;           // those that became object hypotheses
  std::vector<RemovedSeed> removed;  // the other salient positions
  double gamma_per_m2 = 0;           // Eq. 5: how fast the hypotheses fade with distance
  VoxelGrid voxels;
  std::vector<MeanColor> colors;  // of the voxels; empty where only shape counts
  // One entry a voxel, 0 = background.
  std::vector<int> labels;    // after the graph cut: k of the hypothesis of seeds[k - 1]
  std::vector<int> segments;  // connected parts of them, before those of one object are joined
  std::vector<int> merged;    // after that, before it is decided what is an object
  MergeTree tree;             // of the segments
  std::vector<ObjectEvidence> evidence;  // of its nodes
  cv::Mat standing;  // CV_8UC1, not 0 where a surface stands in for missing depth; may be empty
  // Of each object, every grasp that was judged for one of the grippers.
  std::vector<std::vector<ScoredGrasp>> grasp_candidates;
};

}  // namespace fovea
