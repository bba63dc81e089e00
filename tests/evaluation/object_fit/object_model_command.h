#pragma once

#include <CLI/CLI.hpp>

namespace fovea::evaluation {

// Adds `fovea-eval object-model`.
void AddObjectModelCommand(CLI::App& app);

}  // namespace fovea::evaluation
