#pragma once

#include <string>

namespace fovea::cli {

// Throws std::invalid_argument that names --server unless `address` is what client::Client takes:
// one or several of HOST:PORT and unix:/PATH.
void CheckServerAddress(const std::string& address);

}  // namespace fovea::cli
