// Whether one can see past the lower borders of segments: what stands does not hang free.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea {

struct LowerBorder {
  int num_pixels = 0;  // below which something else was measured
  int num_free = 0;    // of them, those below which it is farther away by more than noise
  int num_hidden = 0;  // of them, those below which it is nearer by more than noise

  void Add(const LowerBorder& other) {
    num_pixels += other.num_pixels;
    num_free += other.num_free;
    num_hidden += other.num_hidden;
  }
};

// One entry a label, the background's first; empty for labels of which `looked_at` is 0. `labels`:
// CV_16UC1, below looked_at.size(); `points`: CV_32FC3, NaN = none; `up`: unit vector. Looks
// across shadows, like DepthBeyond. A camera that looks straight down sees no lower borders. Cost:
// proportional to the image.
std::vector<LowerBorder> FindLowerBorders(const cv::Mat& labels, const cv::Mat& points,
                                          const CameraIntrinsics& intrinsics,
                                          const Eigen::Vector3f& up,
                                          const std::vector<char>& looked_at);

}  // namespace fovea
