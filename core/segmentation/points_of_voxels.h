// The points of voxels that may be objects.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/segmentation/voxel_grid.h"
#include "core/types/interruption.h"

namespace fovea {

// Calls visit(voxel, point, pixel) for every point of a voxel that is not background. `points`:
// CV_32FC3, the image that the grid was built from.
template <typename Visit>
void ForEachPoint(const VoxelGrid& grid, const cv::Mat& points,
                  const std::vector<char>& is_background, Visit visit) {
  for (int row = 0; row < points.rows; ++row) {
    InterruptionPoint();
    const int* voxel_of_pixel = grid.voxel_of_pixel.ptr<int>(row);
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    for (int col = 0; col < points.cols; ++col) {
      const int v = voxel_of_pixel[col];
      if (v < 0 || is_background[v]) continue;
      visit(v, Eigen::Vector3f(point[col][0], point[col][1], point[col][2]), cv::Point(col, row));
    }
  }
}

}  // namespace fovea
