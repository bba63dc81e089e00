// Where on the supports of a scene there is room to put something down.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/types/detections.h"
#include "core/types/place.h"

namespace fovea {

// The places with most room first; they do not overlap. A place is free where the support was seen
// to be empty: what is hidden, or no point fell on, is not free, and nothing may stand within the
// height of what shall be put down. Boxes of objects count whole, with what is hidden of them.
//
// `points`: CV_32FC3, NaN = none; `tolerance_m`: points this close to a support lie on it. Looked
// at in cells of 1 cm (larger ones where a support is longer than 4 m) and 4 directions. Some ms.
std::vector<FreePlace> FindFreePlaces(const cv::Mat& points, const std::vector<Support>& supports,
                                      const std::vector<DetectedObject>& objects,
                                      const PlaceOptions& options, float tolerance_m = 0.015F);

}  // namespace fovea
