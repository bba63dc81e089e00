// Box scores of sweeps and scores of methods as charts.
#pragma once

#include <string>
#include <vector>

#include "tests/evaluation/detection_run.h"
#include "tests/evaluation/plot.h"

namespace fovea::evaluation {

// Box precision, recall and F1 over the values of an option, as in the paper's Figure 6a.
Chart SweepChart(const std::string& option, const std::vector<double>& values,
                 const std::vector<Summary>& summaries);

// Box F1, overlap F, obj75 and boundary F of each method.
Chart MethodsChart(const std::vector<std::string>& methods, const std::vector<Summary>& summaries);

}  // namespace fovea::evaluation
