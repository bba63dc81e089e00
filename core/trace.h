// What a caller may want to see of the steps between a frame and its objects.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/mean_color.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/detections.h"

namespace fovea {

struct Trace {
  cv::Mat color_saliency;   // CV_32FC1 in [0, 1], frame size
  cv::Mat depth_saliency;   // CV_32FC1 in [0, 1], frame size
  std::vector<Seed> seeds;  // those that became object hypotheses
  VoxelGrid voxels;
  std::vector<MeanColor> colors;  // of the voxels
  std::vector<int> segments;      // one entry a voxel, before parts are joined; 0 = background
};

}  // namespace fovea
