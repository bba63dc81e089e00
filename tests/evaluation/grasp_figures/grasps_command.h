// `fovea-eval grasps`: how many of the grasps that are answered for generated scenes succeed.
#pragma once

#include <CLI/CLI.hpp>

namespace fovea::evaluation {

// Adds the sub-command; parsing it runs it.
void AddGraspsCommand(CLI::App& app);

}  // namespace fovea::evaluation
