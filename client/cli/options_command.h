#pragma once

#include "client/cli/connection.h"

namespace fovea::cli {

// Prints every option of the server's method: name, value in each profile, range, unit, meaning.
int PrintOptions(const ConnectionFlags& flags);

}  // namespace fovea::cli
