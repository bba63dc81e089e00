#pragma once

#include <CLI/App.hpp>

namespace fovea::server {

// Has options refuse values that are empty, as a script or a template with an unset variable makes
// them, and that would pass for none or zero; and numbers with leading zeros, which would be octal.
void RequirePlainValues(CLI::App& app);

}  // namespace fovea::server
