// Pictures of the grasps in generated scenes.
#pragma once

#include <string>
#include <vector>

#include "core/types/gripper.h"
#include "tests/evaluation/generated/generated_run.h"

namespace fovea::evaluation {

// Writes the first grasps of matched objects to `folder`, a picture for each frame and gripper that
// has any: KIND_SEED_SENSOR_GRIPPER.png.
void WriteOverlays(const std::string& folder, const GeneratedScene& scene,
                   const std::vector<Gripper>& grippers);

}  // namespace fovea::evaluation
