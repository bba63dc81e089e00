#pragma once

#include <string>

#include "client/client.h"

namespace fovea::cli {

// Prints every option of the server's method: name, value in each profile, range, unit, meaning.
// `heading` stands above them.
void PrintOptions(const std::string& heading, const client::Client& client);

}  // namespace fovea::cli
