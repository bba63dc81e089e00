#pragma once

#include <string>

namespace fovea::server {

// Throws std::invalid_argument that names `flag` where the path is a pipe, which would be waited
// for and cannot be read again, as SIGHUP does, a device other than /dev/null, which need not end,
// or a file of more than 16 MiB, as no configuration, certificates or tokens have. What is not
// there at all is for whoever opens it.
void RequireFileToReadAgain(const std::string& flag, const std::string& path);

// The same, and where it is not there or cannot be read, with the system's reason.
void RequireReadable(const std::string& flag, const std::string& path);

}  // namespace fovea::server
