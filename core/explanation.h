// Says in words why a detection found few objects, or none.
#pragma once

#include <string>
#include <vector>

#include "core/types/detections.h"

namespace fovea {

// One sentence for each step that left little or nothing, the most telling first; empty where
// nothing is unusual. Looks at everything in `detections` but the messages. `has_region`: only a
// part of the scene was to be looked at.
std::vector<std::string> ExplainLosses(const Detections& detections, bool has_region = false);

}  // namespace fovea
