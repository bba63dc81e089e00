#pragma once

#include <string>
#include <vector>

namespace fovea::cli {

// Throws std::invalid_argument that names --server unless `address` is what client::Client takes:
// one or several of HOST:PORT and unix:/PATH.
void CheckServerAddress(const std::string& address);

// Each of them on its own, after the same check.
std::vector<std::string> SplitServerAddresses(const std::string& addresses);

}  // namespace fovea::cli
