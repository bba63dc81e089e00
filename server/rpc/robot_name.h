#pragma once

#include <grpcpp/support/string_ref.h>

#include <map>
#include <string>

namespace fovea::server {

// The name that turns are taken by: the metadata `fovea-robot`, else the peer's host, since all
// connections of one machine are one robot. Throws std::invalid_argument for a name that is not 1
// to 64 printable ASCII characters.
std::string RobotName(const std::multimap<grpc::string_ref, grpc::string_ref>& metadata,
                      const std::string& peer);

}  // namespace fovea::server
