// Where on the supports of a scene there is room to put something down.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/relations/support_view.h"
#include "core/scene/support_surface.h"
#include "core/types/detections.h"
#include "core/types/place.h"

namespace fovea {

// The places with most room first; they do not overlap. A place is free where the support was seen
// to be empty: what is hidden, or gave no depth, is not free, and nothing may stand within the
// height of what shall be put down. Of objects all pixels and their boxes count, however low, with
// what is hidden of them. What is no object may be overlooked up to 2 cm², and as far as it is as
// low as the support scatters.
//
// `objects`: that with label k at k - 1; `support_options`: by which the supports were found.
// Looked at in cells of 1 cm (larger ones where a support is longer than 4 m) and 4 directions.
// Some ms.
std::vector<FreePlace> FindFreePlaces(const ViewedScene& scene,
                                      const std::vector<Support>& supports,
                                      const std::vector<DetectedObject>& objects,
                                      const PlaceOptions& options,
                                      const SupportOptions& support_options);

}  // namespace fovea
