// What surrounds a segment in the image: an object ends in the open, a table leg at its table, a
// wall at the end of the image. Goes beyond the paper.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea {

struct Outline {
  // Sides of pixels that face another label, and how many of them face the end of the image, or of
  // what was measured of it: registered depth often leaves a margin free.
  int num_sides = 0;
  int num_sides_at_end = 0;

  // Pixels of the upper border, by what lies above them.
  struct Upper {
    int open = 0;      // something farther away or lower, another segment, or nothing measured
    int at_wall = 0;   // a wall at the same distance
    int attached = 0;  // background that goes on upwards at the same distance
    int hidden = 0;    // background that is nearer
    int at_end = 0;    // the end of the image
    int Total() const { return open + at_wall + attached + hidden + at_end; }
  } upper;
};

// `labels`: CV_16UC1, 0 = background; `points`: CV_32FC3, NaN = none; `on_wall`: CV_16UC1, not 0 on
// walls, which objects may stand against; `up`: unit vector. One entry a label, the first for 0.
// Upper borders are found only where up shows in the image: a camera that looks straight down sees
// none.
std::vector<Outline> FindOutlines(const cv::Mat& labels, const cv::Mat& points,
                                  const cv::Mat& on_wall, const CameraIntrinsics& intrinsics,
                                  const Eigen::Vector3f& up);

}  // namespace fovea
