// The plane through points of a depth camera.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/types/detections.h"

namespace fovea {

// Least squares; each point weighs 1/z⁴, the inverse variance of structured-light depth. The
// normal points to the side of `towards`. At least three points.
SupportSurface FitPlane(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& towards);

}  // namespace fovea
