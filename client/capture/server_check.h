#pragma once

#include <string>

#include "client/cli/connection.h"
#include "client/client.h"

namespace fovea::capture {

// Throws std::runtime_error where a server of that version may not understand a client of this
// one: the first numbers differ, or the second while the first is 0.
void CheckVersions(const std::string& client, const std::string& server);

// Asks the server at `flags` who it is. Returns what to tell a person; throws std::exception with
// one line of text where it does not answer, or is of another version.
std::string CheckServer(const client::Client& client, const cli::ConnectionFlags& flags);

}  // namespace fovea::capture
