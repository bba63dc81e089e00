// `fovea-eval detection`: how well the detector finds the objects of a folder of scenes.
#pragma once

#include <CLI/CLI.hpp>

namespace fovea::evaluation {

// Adds the sub-command; parsing it runs it.
void AddDetectionCommand(CLI::App& app);

}  // namespace fovea::evaluation
