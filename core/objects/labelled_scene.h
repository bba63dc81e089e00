// A scene whose voxels are labelled: what the search for objects among the labels starts from.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/segmentation/mean_color.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct LabelledScene {
  const VoxelGrid& grid;
  const std::vector<int>& labels;        // one entry a voxel, 0 = background
  const cv::Mat& points;                 // CV_32FC3 in the camera frame, NaN = none
  const cv::Mat& lab;                    // CV_8UC3, as of LabOf
  const std::vector<MeanColor>& colors;  // one entry a voxel
  const CameraIntrinsics& intrinsics;
  Eigen::Vector3f up;  // unit vector
  const std::vector<Support>& supports;
  const cv::Mat& standing;           // CV_8UC1, not 0 where a surface stands in for missing depth
  const std::vector<char>& on_wall;  // one entry a voxel, not 0 on walls of the room
  const cv::Mat& unseen;             // as of RgbdFrame
};

}  // namespace fovea
