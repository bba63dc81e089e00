// What a program can read of an error, beside its text: google.rpc's standard details, which travel
// as `grpc-status-details-bin`.
#pragma once

#include <grpcpp/support/status.h>

#include <chrono>
#include <optional>
#include <string>

#include "server/conversion/field_error.h"

namespace fovea::server {

// INVALID_ARGUMENT. Has a BadRequest where the path is that of a field of the request:
// "frame.depth.data".
grpc::Status InvalidArgument(const FieldError& error);

// With a RetryInfo.
grpc::Status WithRetryInfo(grpc::StatusCode code, const std::string& text,
                           std::chrono::milliseconds retry_after);
grpc::Status ResourceExhausted(const std::string& text, std::chrono::milliseconds retry_after);

// What those put in; empty where there is none.
std::string FieldOf(const grpc::Status& status);
std::optional<std::chrono::milliseconds> RetryAfterOf(const grpc::Status& status);

}  // namespace fovea::server
