// What the objects of a scene stand in.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/scene/support_surface.h"

namespace fovea {

struct ObjectSurroundings {
  cv::Mat points;                 // CV_32FC3, camera frame, NaN = none; empty unless needed
  std::vector<Support> supports;  // the dominating one first
  cv::Mat measured_m = {};        // CV_32FC1, as the camera measured it, NaN = none; empty unless
                                  // needed
  cv::Mat assumed = {};           // CV_8UC1, not 0 where nothing was measured and no object is;
                                  // empty where no point stands in for what cannot be measured
};

}  // namespace fovea
