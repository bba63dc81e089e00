// What must be taken away before what.
#pragma once

#include <vector>

#include "core/types/detections.h"

namespace fovea {

// Fills `blocked_by` of each object from `stands_on` and `leans_on` of all: what stands on it or
// leans against it, and on that, what must go first first. Object k has label k.
void BlockByWhatStandsOn(std::vector<DetectedObject>& objects);

}  // namespace fovea
