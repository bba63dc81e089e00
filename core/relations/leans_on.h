// What leans against what.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/types/detections.h"

namespace fovea {

// Fills `leans_on` of each object: the other one that holds it up, where what was seen of it is one
// flat face that is tilted from the upright by 9 to 60 degrees, faces up, and has the other's box
// within 60 mm behind its upper half, while its lower end lies below the top of that. None leans on
// what it stands on, or on what rests on it: of two that lean against each other, the one that is
// held better does. Object k has label k; `up`: unit vector. Cost: some 0.1 ms an object.
void FindWhatLeans(const Eigen::Vector3f& up, std::vector<DetectedObject>& objects);

}  // namespace fovea
