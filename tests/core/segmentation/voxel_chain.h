// Voxels in a row, for tests of labels.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/segmentation/voxel_grid.h"

namespace fovea {

// A row of voxels, one pixel each, all neighbours in a chain.
inline VoxelGrid Chain(int length) {
  VoxelGrid grid;
  grid.voxels.resize(length);
  grid.voxel_of_pixel = cv::Mat(1, length, CV_32SC1);
  for (int i = 0; i < length; ++i) {
    grid.voxel_of_pixel.at<int>(i) = i;
    if (i > 0) grid.edges.push_back({i - 1, i});
  }
  return grid;
}

}  // namespace fovea
