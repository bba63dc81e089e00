#pragma once

#include <string>

namespace fovea::flags {

// Throws std::invalid_argument that starts with `flag` unless `listen` is HOST:PORT with a port of
// 0 to 65535; whether the host is one of this machine shows where it is listened on.
void RequireListenAddress(const char* flag, const std::string& listen);

}  // namespace fovea::flags
