// Figures of grasps as text.
#pragma once

#include <ostream>

#include "tests/evaluation/grasp_figures/grasp_run.h"

namespace fovea::evaluation {

// For each gripper: rows for all objects and for groups of them, probabilities, how first grasps
// end, and those that fail with the highest probability.
void PrintGrasps(std::ostream& out, const GraspRun& run);

}  // namespace fovea::evaluation
