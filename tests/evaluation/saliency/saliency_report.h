// Saliency scores as tables, JSON and a plot, like the paper's Tables 1 to 3.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "tests/evaluation/plot.h"
#include "tests/evaluation/saliency/saliency_run.h"

namespace fovea::evaluation {

// Per method and score: the mean over the images without blur, the best one of the sweep with its
// standard error and its sigma in image widths, and the median time of a map.
void PrintSaliency(std::ostream& out, const std::vector<SaliencyResult>& results,
                   const std::vector<double>& sigmas);

// One chart per score: its mean over the images against sigma.
std::vector<Chart> SaliencyCharts(const std::vector<SaliencyResult>& results,
                                  const std::vector<double>& sigmas);

// Best and all means, with everything that is needed to repeat them.
nlohmann::json ToJson(const std::vector<SaliencyResult>& results,
                      const SaliencyRunOptions& options);

}  // namespace fovea::evaluation
