#pragma once

#include <string>

namespace fovea::cli {

// Throws std::invalid_argument that names --server unless `address` is HOST:PORT (IPv6 in brackets)
// or says by its scheme that it is another target of gRPC, such as ipv4:A:PORT,B:PORT or unix:PATH.
// gRPC itself would take "localhost" for port 443, and look a web address up as a name.
void CheckServerAddress(const std::string& address);

}  // namespace fovea::cli
