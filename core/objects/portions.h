// In which order a scene is looked at where the time may not suffice for all of it.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

// The foreground in portions of about equal size, the most salient first: which voxels are not in
// each (one entry a voxel). Connected parts stay whole, so that there may be fewer than
// `num_portions`; at least one.
//
// `saliency`: CV_32FC1 of the frame's size.
std::vector<std::vector<char>> SalientPortions(const VoxelGrid& grid,
                                               const std::vector<char>& is_background,
                                               const cv::Mat& saliency, int num_portions);

}  // namespace fovea
