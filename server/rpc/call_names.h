// The names that callers give by metadata: of 1 to 64 printable ASCII characters, else
// std::invalid_argument is thrown.
#pragma once

#include <grpcpp/support/string_ref.h>

#include <map>
#include <string>

namespace fovea::server {

using Metadata = std::multimap<grpc::string_ref, grpc::string_ref>;

constexpr const char* kRobotKey = "fovea-robot";
constexpr const char* kRequestIdKey = "fovea-request-id";

// The name that turns are taken by: `fovea-robot`, else the peer's host, since all connections of
// one machine are one robot.
std::string RobotName(const Metadata& metadata, const std::string& peer);

// `fovea-request-id`, else a number that no other request has.
std::string RequestId(const Metadata& metadata);

}  // namespace fovea::server
