// What must be taken away before what.
#pragma once

#include <vector>

#include "core/types/detections.h"

namespace fovea {

// Fills `blocked_by` of each object from `stands_on` and `leans_on` of all: what stands on it or
// leans against it, and what does so on those, each before whatever it rests on. Object k has label
// k.
void BlockByWhatStandsOn(std::vector<DetectedObject>& objects);

}  // namespace fovea
