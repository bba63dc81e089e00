#pragma once

#include <optional>
#include <string>

#include "server/server_options.h"
#include "server/settings.h"

namespace fovea::server {

// Reads the flags. Empty after --help, --version or --list-options, which it prints. Throws
// std::invalid_argument with one line of text for flags that are unknown or do not validate.
std::optional<ServerOptions> ParseCommandLine(int argc, char** argv, Settings* settings = nullptr);

// What to say where callers need a token and the file holds none.
std::string NoTokens(const ServerOptions& options);

}  // namespace fovea::server
