#pragma once

#include <CLI/CLI.hpp>

namespace fovea::evaluation {

// Adds `fovea-eval objects`.
void AddObjectsCommand(CLI::App& app);

}  // namespace fovea::evaluation
