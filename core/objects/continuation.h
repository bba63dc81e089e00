// Which segments are, for all one can see, a part of something larger: a leg ends at its table, a
// wall at the end of the image. Goes beyond the paper.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/objects/plausibility.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct ContinuationOptions {
  // Segments of whose upper border more than this share ends at background that goes on upwards or
  // hides it, or at the end of the image, are part of something larger; so are those of whose whole
  // outline more than this share ends with the image. 1 switches the test off.
  double max_share = 1;
};

// `labels`: one entry a voxel, 0 = background; `points`: CV_32FC3 of the frame; `on_wall`: one
// entry a voxel, not 0 on walls, which objects may stand against; `up`: unit vector. What is
// removed counts as background for the segments below it.
PlausibleSegments RemoveContinued(const VoxelGrid& grid, const std::vector<int>& labels,
                                  const cv::Mat& points, const CameraIntrinsics& intrinsics,
                                  const std::vector<char>& on_wall, const Eigen::Vector3f& up,
                                  const ContinuationOptions& options = {});

}  // namespace fovea
