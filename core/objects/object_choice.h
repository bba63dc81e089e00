// Which unions of segments are objects: a random field over the tree of merges.
#pragma once

#include <vector>

#include "core/segmentation/merge_tree.h"

namespace fovea {

// Each set of nodes of which none lies within another is a way to see the scene; its odds are the
// product of the weights of its nodes (1 for the empty set). Returns the share of the odds of all
// of them that the sets with a node have: the probability that the node is an object.
// `log_weights`: one entry a node, natural logarithms. Cost: linear.
std::vector<double> ObjectProbabilities(const MergeTree& tree,
                                        const std::vector<double>& log_weights);

struct ChoiceOptions {
  // What is less likely an object is none; 0 … 1.
  double min_probability = 0.3;
};

// The nodes of the tree, none within another, for which the sum of probability − min_probability is
// largest: a union is taken whole where it is likelier an object than its parts are objects.
// `probabilities`: one entry a node. Rising node numbers.
std::vector<int> ChooseObjects(const MergeTree& tree, const std::vector<double>& probabilities,
                               const ChoiceOptions& options = {});

// The label of each voxel: k + 1 for all segments of chosen[k], 0 for what belongs to none.
// `labels`: one entry a voxel, those of the tree's segments.
std::vector<int> LabelsOfChosen(const MergeTree& tree, const std::vector<int>& chosen,
                                const std::vector<int>& labels);

}  // namespace fovea
