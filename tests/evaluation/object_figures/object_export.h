// Figures of boxes, shapes and relations as JSON and a chart.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "tests/evaluation/object_figures/object_run.h"
#include "tests/evaluation/plot.h"

namespace fovea::evaluation {

// All figures, and each object with its errors.
nlohmann::json ToJson(const ObjectRun& run);

// The IoU of boxes by class; none without objects that are seen to 90 %.
std::vector<Chart> ObjectCharts(const ObjectRun& run);

}  // namespace fovea::evaluation
