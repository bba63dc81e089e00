// What the data term needs of the points of each voxel.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/data_term.h"
#include "core/segmentation/foreground.h"

namespace fovea {

// One entry a voxel.
struct PointStatistics {
  std::vector<float> variance;         // mean squared distance of the points to their mean
  std::vector<float> background_cost;  // Eq. 2 for the background label
};

// Arguments as of DataTerm; `foreground`: of this grid and background.
PointStatistics CollectStatistics(const VoxelGrid& grid, const cv::Mat& points,
                                  const std::vector<char>& is_background,
                                  const Foreground& foreground, const cv::Mat& on_support,
                                  const std::vector<Seed>& seeds, const DataTermOptions& options);

}  // namespace fovea
