// Where the upper end of a segment is: an object ends in the open, a table leg at its table. Goes
// beyond the paper.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea {

// Pixels of a segment's upper border by what lies above them in the image.
struct UpperBorder {
  int open = 0;      // something farther away or lower, another segment, or nothing measured
  int attached = 0;  // background that goes on upwards at the same distance
  int hidden = 0;    // background that is nearer
  int cut = 0;       // the end of the image

  int Total() const { return open + attached + hidden + cut; }
};

// `labels`: CV_16UC1, 0 = background; `points`: CV_32FC3, NaN = none; `on_wall`: CV_8UC1, not 0
// on walls, which objects may stand against; `up`: unit vector. One
// entry a label, the first for 0. Pixels count only where up shows in the image: a camera that
// looks straight down sees no upper borders.
std::vector<UpperBorder> FindUpperBorders(const cv::Mat& labels, const cv::Mat& points,
                                          const cv::Mat& on_wall,
                                          const CameraIntrinsics& intrinsics,
                                          const Eigen::Vector3f& up);

}  // namespace fovea
