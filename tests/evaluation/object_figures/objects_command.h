// `fovea-eval objects`: how right boxes, shapes and relations are in generated scenes.
#pragma once

#include <CLI/CLI.hpp>

namespace fovea::evaluation {

// Adds the sub-command; parsing it runs it.
void AddObjectsCommand(CLI::App& app);

}  // namespace fovea::evaluation
