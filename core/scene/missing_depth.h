// Things that the camera cannot measure: clear, black and shiny ones leave a hole in the depth of
// the surface that they stand on. Goes beyond the paper.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/depth/normals.h"
#include "core/scene/support_surface.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct StandInLimits {
  double max_height_m = 0;  // above the support
  double max_depth_m = 0;   // as of BackProject
};

// Stands an upright surface, which faces the camera, in each hole in front of a support, where the
// line of sight through the lowest pixel of the hole meets it: the least that can be there. What a
// second camera or projector beside does not see, behind the edge of something nearer, is no such
// hole; neither are holes at the border of the image, small ones, those that lie for the most part
// beside every support, and those that are looked down into too steeply to stand a surface in them.
//
// `depth_m`: CV_32FC1, NaN = none. `points`: CV_32FC3 as of BackProject, and `normals`, of all of
// its pixels or some, get the surfaces; `points` in a copy of its own. Returns CV_8UC1, not 0 where
// they are. Cost: proportional to the image.
cv::Mat StandInForMissing(const cv::Mat& depth_m, const std::vector<Support>& supports,
                          const CameraIntrinsics& intrinsics, const StandInLimits& limits,
                          cv::Mat& points, NormalMap& normals);

}  // namespace fovea
