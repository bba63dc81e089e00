// The data term of the background (paper Eq. 2 and 6), point by point.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/data_term.h"
#include "core/segmentation/voxel_grid.h"

namespace fovea::paper {

// One entry a voxel: -ln p on average over its points; 0 for voxels with `is_background` set.
// Points where `on_support` (CV_8UC1 of the image's size, or empty for none) is not 0 are
// background with a probability of one (section 3.2). The other arguments are those of DataTerm.
std::vector<float> BackgroundCosts(const VoxelGrid& grid, const cv::Mat& points,
                                   const std::vector<char>& is_background,
                                   const cv::Mat& on_support, const std::vector<Seed>& seeds,
                                   const DataTermOptions& options);

}  // namespace fovea::paper
