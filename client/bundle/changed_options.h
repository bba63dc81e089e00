#pragma once

#include "fovea/v1/detection.pb.h"

namespace fovea::bundle {

// What is asked of a frame that was sent once, alone: the options of then with `changes`, where the
// time, the grippers and the places to find are replaced as wholes, and parameters one by one.
void ChangeOptions(const v1::DetectOptions& changes, v1::DetectOptions* options);

}  // namespace fovea::bundle
