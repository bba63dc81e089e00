// What was considered and is not reported, and why.
#pragma once

#include <vector>

#include "core/objects/object_model.h"
#include "core/segmentation/merge_tree.h"
#include "core/types/detections.h"

namespace fovea {

// For each largest part of the tree of which nothing is chosen, what in it is likeliest an object,
// where that has the pixels of an object at least. The reason is the evidence that speaks against
// it most. One entry a node: `evidence`, `probabilities`.
std::vector<RejectedObject> FindRejected(const MergeTree& tree, const std::vector<int>& chosen,
                                         const std::vector<ObjectEvidence>& evidence,
                                         const std::vector<double>& probabilities,
                                         const ObjectModel& model);

// The likeliest 100, likeliest first.
void KeepLikeliest(std::vector<RejectedObject>& rejected);

}  // namespace fovea
