#pragma once

#include <grpcpp/support/status.h>

namespace fovea::server {

// The one place where exceptions become statuses. Call it inside a catch block:
// std::invalid_argument → INVALID_ARGUMENT, Cancelled → DEADLINE_EXCEEDED where
// `deadline_passed`, else CANCELLED, std::bad_alloc → RESOURCE_EXHAUSTED, anything else →
// INTERNAL with the text in the log only.
grpc::Status StatusOfCurrentException(bool deadline_passed);

// "INVALID_ARGUMENT".
const char* NameOf(grpc::StatusCode code);

}  // namespace fovea::server
