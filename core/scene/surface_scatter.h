// How much the measured points of a surface scatter about it: what the noise of this camera is at
// this distance and angle, whatever the camera is.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/scene/support_surface.h"

namespace fovea {

// Above which share of the tolerance points stand on the surface rather than belong to it:
// `tolerance_sigmas` standard deviations of the scatter, between 0.35, as neither tables nor lenses
// are perfect, and 2.5. `points`: those within the tolerance, so that what scatters farther is
// underrated. 1 where none lies below the surface.
float ToleranceShare(const std::vector<Eigen::Vector3f>& points, const SupportSurface& surface,
                     const SupportOptions& options);

}  // namespace fovea
