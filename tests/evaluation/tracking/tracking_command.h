#pragma once

#include <CLI/CLI.hpp>

namespace fovea::evaluation {

// fovea-eval tracking: identities in generated streams.
void AddTrackingCommand(CLI::App& app);

}  // namespace fovea::evaluation
