#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/status.h>

#include <chrono>

namespace fovea::server {

// The one place where exceptions become statuses. Call it inside a catch block:
// FieldError and TooComplex → INVALID_ARGUMENT, Unauthenticated → UNAUTHENTICATED,
// PermissionDenied → PERMISSION_DENIED, Overloaded → RESOURCE_EXHAUSTED,
// Cancelled → CANCELLED (a Caller knows who ended the call), ComputeLimitPassed and
// std::bad_alloc → RESOURCE_EXHAUSTED, the latter to come back in a second; anything else →
// INTERNAL with the text in the log only.
grpc::Status StatusOfCurrentException();

// Of a caller that left, or whose deadline passed.
grpc::Status StatusOfGoneCaller(bool deadline_passed);

grpc::Status StatusOfStopping();

// Of one that the server cancels, having waited for it for long enough.
grpc::Status StatusOfGivenUp();

// Of a call whose message did not come in time.
grpc::Status StatusOfSlowness();

// Of a call whose answer was not taken in time, or took room that others need.
grpc::Status StatusOfUntakenAnswer();
grpc::Status StatusOfUnsentAnswer();

// Tells the caller when to try again: the trailing metadata `retry-after-ms`, and
// `grpc-retry-pushback-ms`, which gRPC's own retries heed.
void AddRetryAfter(std::chrono::milliseconds wait, grpc::ServerContext* context);

// "INVALID_ARGUMENT".
const char* NameOf(grpc::StatusCode code);

}  // namespace fovea::server
