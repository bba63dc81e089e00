// Says in words why a detection found few objects, or none.
#pragma once

#include <string>
#include <vector>

#include "core/types/detections.h"

namespace fovea {

// What was asked for beside the objects.
struct Asked {
  bool region = false;  // only a part of the scene is looked at
  bool place = false;   // to put something down
};

// One sentence for each step that left little or nothing, the most telling first; empty where
// nothing is unusual. Looks at everything in `detections` but the messages.
std::vector<std::string> ExplainLosses(const Detections& detections, const Asked& asked = {});

}  // namespace fovea
