// What rests on what.
#pragma once

#include <vector>

#include "core/types/detections.h"

namespace fovea {

// Whether the object with the first label stands on the other or leans against it, directly or by
// others between them (`stands_on` and `leans_on`). Object k has label k.
bool RestsOn(const std::vector<DetectedObject>& objects, int label, int on);

}  // namespace fovea
