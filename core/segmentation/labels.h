// Labellings of voxels: one entry a voxel, 0 = background, segments 1 … n.
#pragma once

#include <cstddef>
#include <vector>

#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/lists.h"

namespace fovea {

// Splits every label into its connected parts, so that each segment is one piece. The labels of
// the argument may be any non-negative numbers.
std::vector<int> SplitIntoSegments(const VoxelGrid& grid, const std::vector<int>& labels);

// Gives all labels of a set one number, or each label its own: 1 … n in order of their first voxel.
std::vector<int> Renumbered(const std::vector<int>& labels, DisjointSets& sets);

std::vector<int> Renumbered(std::vector<int> labels);

// The connected parts of what is not background, 1 … n, one entry a voxel; 0 = background.
std::vector<int> PartsOfForeground(const VoxelGrid& grid, const std::vector<char>& is_background);

// Images of labels have 16 bits: throws TooComplex for more than 65535 segments.
void RequireFewSegments(const std::vector<int>& segments);

// The label of every pixel's voxel. Returns CV_16UC1; 0 where there is none. At most 65535 labels.
cv::Mat LabelImage(const VoxelGrid& grid, const std::vector<int>& labels);

// The same where the mask (CV_8UC1) is not 0, and 0 elsewhere.
cv::Mat LabelsWithin(const VoxelGrid& grid, const std::vector<int>& labels, const cv::Mat& mask);

// True if the eight neighbours of a pixel are in the image and have its label. `labels`: CV_16UC1.
bool IsInterior(const cv::Mat& labels, int row, int col);

// The indices of what has each label, ascending; none for the background's, which come first.
Lists<int> IndicesOfLabels(const std::vector<int>& labels);

// The highest label.
std::size_t CountLabels(const std::vector<int>& labels);

}  // namespace fovea
