// Figures of grasps as JSON and charts.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "tests/evaluation/grasp_figures/grasp_run.h"
#include "tests/evaluation/plot.h"

namespace fovea::evaluation {

// All figures, and each object with what became of its grasps.
nlohmann::json ToJson(const GraspRun& run);

// The share of first grasps that succeed by class, and over their probability.
std::vector<Chart> GraspCharts(const GraspRun& run);

}  // namespace fovea::evaluation
