// `fovea-eval kinship`: fits the weights by which the detector joins segments.
#pragma once

#include <CLI/CLI.hpp>

namespace fovea::evaluation {

// Adds the sub-command; parsing it runs it.
void AddKinshipCommand(CLI::App& app);

}  // namespace fovea::evaluation
