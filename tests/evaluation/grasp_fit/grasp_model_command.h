#pragma once

#include <CLI/CLI.hpp>

namespace fovea::evaluation {

// fovea-eval grasp-model: fits how likely grasps are to succeed.
void AddGraspModelCommand(CLI::App& app);

}  // namespace fovea::evaluation
