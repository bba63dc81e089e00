// `fovea-eval saliency`: how well saliency maps foretell where people look.
#pragma once

#include <CLI/CLI.hpp>

namespace fovea::evaluation {

// Adds the sub-command; parsing it runs it.
void AddSaliencyCommand(CLI::App& app);

}  // namespace fovea::evaluation
