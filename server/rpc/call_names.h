// The names that callers give by metadata: of 1 to 64 printable ASCII characters, else
// std::invalid_argument is thrown. And the trace that they are part of.
#pragma once

#include <grpcpp/support/string_ref.h>

#include <map>
#include <optional>
#include <string>

#include "server/tracing/trace_context.h"

namespace fovea::server {

using Metadata = std::multimap<grpc::string_ref, grpc::string_ref>;

constexpr const char* kRobotKey = "fovea-robot";
constexpr const char* kRequestIdKey = "fovea-request-id";
// Given, with whatever value, where the robot has a place in line at another server and asks
// whether there is room here at once.
constexpr const char* kOnlyIfRoomKey = "fovea-only-if-room";

// The name that turns are taken by: `fovea-robot`, else the peer's host, since all connections of
// one machine are one robot.
std::string RobotName(const Metadata& metadata, const std::string& peer);

// `traceparent`; none where it is malformed or there twice.
std::optional<TraceContext> TraceOf(const Metadata& metadata);

// `fovea-request-id`, else a number that no other request has.
std::string RequestId(const Metadata& metadata);

}  // namespace fovea::server
