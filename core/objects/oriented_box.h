// The box of an object that stands on its support.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/types/detections.h"

namespace fovea {

struct BoxOptions {
  // The box ends at the support surface if the lowest visible point is not farther above or below
  // it than this; metres. What is higher stands on something else, what is lower hangs beyond its
  // edge or lies below it.
  double max_gap_m = 0.03;
};

// The smallest box around the points among those with an axis along `up`: a minimum-area
// rectangle around the footprint times the height range. (Principal axes would give a square
// footprint its diagonal.)
//
// `points`: not empty, camera frame; `up`: unit vector.
OrientedBox FitOrientedBox(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& up,
                           const std::optional<SupportSurface>& support,
                           const BoxOptions& options = {});

}  // namespace fovea
