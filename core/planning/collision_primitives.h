// Objects and supports as solids that collision checkers know.
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "core/scene/support_surface.h"
#include "core/types/detections.h"
#include "core/types/planning.h"

namespace fovea {

// The smallest of them that encloses the object as it is described: its cylinder or sphere where
// its shape is one, a cylinder around what is round about the upright, else its oriented box. Where
// more than a hundredth of its points lie 5 mm and more outside of that (a handle, a spout), this
// or the oriented box, grown to hold all but a hundredth, whichever is smaller then.
CollisionPrimitive PrimitiveOf(const DetectedObject& object);

// A box under what was seen of a support, its upper side in the surface, 20 mm thick: the smallest
// rectangle around the points that lie on it to `tolerance_m` within its footprint, each side at
// least 10 mm; none without such points. `points`: CV_32FC3, NaN = none.
std::optional<CollisionPrimitive> PrimitiveOf(const Support& support, const cv::Mat& points,
                                              float tolerance_m = 0.015F);

}  // namespace fovea
