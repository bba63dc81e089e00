// How high what was seen reaches.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/types/planning.h"

namespace fovea {

// On a grid that is level: at right angles to `up`, a unit vector, its rows away from the camera
// and its columns to the right; height 0 is `offset_m` + up·p = 0. A cell is unknown where no
// surface was seen in it: what is hidden behind things, or was not measured. Surface between
// neighbouring pixels counts as seen where their depths differ by no more than noise (DepthGap_m).
//
// Covers what was seen; where that takes more than `options.max_cells`, the part that is nearest to
// the camera. `points`: CV_32FC3, NaN = none. Some ms.
HeightMap MakeHeightMap(const cv::Mat& points, const Eigen::Vector3f& up, float offset_m,
                        const PlanningOptions& options);

}  // namespace fovea
