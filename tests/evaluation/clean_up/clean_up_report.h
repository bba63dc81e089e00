// How a clean-up went, as tables and JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <vector>

#include "tests/evaluation/clean_up/clean_up_run.h"

namespace fovea::evaluation {

// Every attempt, and what is left.
void PrintSteps(std::ostream& out, const CleanedScene& scene);

// Over all scenes: how many end empty, what was tried, what stops the rest.
void PrintSummary(std::ostream& out, const std::vector<CleanedScene>& scenes);

nlohmann::json ToJson(const std::vector<CleanedScene>& scenes);

}  // namespace fovea::evaluation
