// Surface normals of an organised point cloud.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/types/rgbd_frame.h"

namespace fovea {

struct NormalOptions {
  // The window of the fit reaches this far from its centre; pixels. Gupta: 3 (7×7).
  int window_radius_px = 3;
  // Every how many rows and columns of the window count.
  int sample_px = 1;
  // Normals are computed on every how many rows and columns.
  int step_px = 1;
  // Pixels of the window whose depth differs from the centre's by more than this share of it
  // belong to another surface and are left out; 0.001 … 0.5.
  double max_depth_change = 0.02;
};

// Normals of every step_px-th row and column of an image.
struct NormalMap {
  cv::Mat vectors;  // CV_32FC3, NaN = none; its (row, col) is pixel (row · step_px, col · step_px)
  int step_px = 1;
};

// Least-squares fit of a plane to each pixel's window. On a plane 1/z is linear in the pixel
// coordinates, so the fit is 1/z = a·u + b·v + c (Gupta et al. 2013).
//
// `points`: CV_32FC3 as of BackProject. Returns unit vectors that point towards the camera; NaN
// where the pixel has no depth or fewer than three pixels off a line fit. Cost: proportional to
// width · height / step² · (window / sample)².
NormalMap EstimateNormals(const cv::Mat& points, const CameraIntrinsics& intrinsics,
                          const NormalOptions& options = {});

}  // namespace fovea
