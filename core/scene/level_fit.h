// The level plane that most points agree on (paper section 3.2: the dominating support surface).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/types/detections.h"

namespace fovea {

// The plane at the height where most of the points lie, fitted to them. `points`: those whose
// normal is about vertical, at least one; `up`: unit vector. Its num_points are those within the
// tolerance.
SupportSurface FitLevelSurface(const std::vector<Eigen::Vector3f>& points,
                               const Eigen::Vector3f& up, const SupportOptions& options);

// The same plane fitted anew to other points, of which `surface` is no farther than the tolerance;
// itself where hardly any are near it.
SupportSurface FitAnew(const std::vector<Eigen::Vector3f>& points, const SupportSurface& surface,
                       const SupportOptions& options);

// The points within `widening` tolerances of the surface.
std::vector<Eigen::Vector3f> PointsNear(const std::vector<Eigen::Vector3f>& points,
                                        const SupportSurface& surface,
                                        const SupportOptions& options, float widening = 1);

}  // namespace fovea
