// Where an object ends in the image: the outline of its mask, moved to where its colours end.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/depth/back_projection.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct OutlinePoint {
  Eigen::Vector2f pixel = Eigen::Vector2f::Zero();     // to parts of a pixel
  Eigen::Vector2f outwards = Eigen::Vector2f::Zero();  // unit vector, away from the object
  // Whether the object ends here: else the image does, or something nearer hides the rest.
  bool is_own_end = false;
  // What is seen just beyond: a point, NaN where nothing was measured, and whose it is, 0 =
  // nobody's.
  Eigen::Vector3f beyond = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  int label_beyond = 0;
};

// The points of the outline of label `label` in order, some 2 px apart at 640 px of width and never
// more than 160; none where the mask is too small to have one.
//
// Depth ends some pixels before or beyond what it is of: structured light leaves a band without,
// stereo reaches over. Of all ways around the mask, from 7 px inside to 11 px outside of its
// outline, this is the one along which the colours differ most on both sides and which bends least;
// a shortest path (Amini et al. 1990), so that it is the same way each time. Depth that was
// measured of something else holds the outline back a little, and so does the mask itself.
//
// `labels`: CV_16UC1; `bounds`: of the label. Cost: proportional to the bounds, some 0.1 ms.
std::vector<OutlinePoint> OutlineAlongColors(const RgbdFrame& frame, const PixelPoints& points,
                                             const cv::Mat& labels, int label,
                                             const cv::Rect& bounds);

}  // namespace fovea
