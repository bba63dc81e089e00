// From depth to points.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea {

// The point of every pixel in the camera frame (x right, y down, z forward; metres).
//
// `depth_m`: CV_32FC1, NaN = none; pixels farther than `max_depth_m` count as none. Returns
// CV_32FC3 of its size; all three coordinates are NaN where there is no depth.
cv::Mat BackProject(const cv::Mat& depth_m, const CameraIntrinsics& intrinsics, double max_depth_m);

// The same points, each made when it is asked for: an image of all of them takes its time, most of
// it for memory, and what looks at objects needs few.
class PixelPoints {
 public:
  // `depth_m`: CV_32FC1, NaN = none. Cost: proportional to its width and height.
  PixelPoints(const cv::Mat& depth_m, const CameraIntrinsics& intrinsics);

  const cv::Mat& Depth_m() const { return depth_m_; }

  // All three coordinates are NaN where there is no depth.
  Eigen::Vector3f At(int row, int col) const {
    const float z = depth_m_.ptr<float>(row)[col];
    return {z * ray_x_[col], z * ray_y_[row], z};
  }

 private:
  cv::Mat depth_m_;
  std::vector<float> ray_x_, ray_y_;  // what 1 m of depth is to the right and down
};

}  // namespace fovea
