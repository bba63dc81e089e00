#pragma once

#include <CLI/CLI.hpp>

namespace fovea::evaluation {

// Adds `fovea-eval rgbd-scenes`.
void AddRgbdScenesCommand(CLI::App& app);

}  // namespace fovea::evaluation
