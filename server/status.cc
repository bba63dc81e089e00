#include "server/status.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>

#include "core/detector.h"
#include "core/types/too_complex.h"
#include "server/access/unauthenticated.h"
#include "server/compute_limit.h"
#include "server/conversion/field_error.h"
#include "server/error_details.h"
#include "server/logging/log_limiter.h"
#include "server/scheduling/scheduler.h"

namespace fovea::server {

namespace {

constexpr std::chrono::seconds kUntilThereIsMemory{1};  // others have theirs back by then

}  // namespace

grpc::Status StatusOfCurrentException() {
  try {
    throw;
  } catch (const FieldError& error) {
    return InvalidArgument(error);
  } catch (const TooComplex& error) {
    return InvalidArgument(FieldError("options.parameters[voxels.size_m]", error.what()));
  } catch (const Unauthenticated& error) {
    return {grpc::StatusCode::UNAUTHENTICATED, error.what()};
  } catch (const PermissionDenied& error) {
    return {grpc::StatusCode::PERMISSION_DENIED, error.what()};
  } catch (const Overloaded& error) {
    return ResourceExhausted(error.what(), error.retry_after);
  } catch (const Cancelled&) {
    return StatusOfGoneCaller(/*deadline_passed=*/false);
  } catch (const ComputeLimitPassed& error) {
    return {grpc::StatusCode::RESOURCE_EXHAUSTED, error.what()};
  } catch (const std::bad_alloc&) {
    return ResourceExhausted("not enough memory for this frame", kUntilThereIsMemory);
  } catch (const std::exception& error) {
    LogLimited("internal error", spdlog::level::err,
               std::string("internal error: ") + error.what());
  } catch (...) {
    LogLimited("internal error", spdlog::level::err, "internal error of unknown type");
  }
  return {grpc::StatusCode::INTERNAL, "internal error; the server's log says more"};
}

grpc::Status StatusOfGoneCaller(bool deadline_passed) {
  if (deadline_passed) {
    return {grpc::StatusCode::DEADLINE_EXCEEDED, "the deadline passed before the answer"};
  }
  return {grpc::StatusCode::CANCELLED, "the caller left"};
}

grpc::Status StatusOfStopping() {
  return {grpc::StatusCode::UNAVAILABLE, "the server is stopping"};
}

grpc::Status StatusOfGivenUp() {
  return {grpc::StatusCode::UNAVAILABLE,
          "the server has stopped before the answer (--drain-timeout-s)"};
}

grpc::Status StatusOfSlowness() {
  return {grpc::StatusCode::CANCELLED, "the message did not come in time (--max-transfer-s)"};
}

grpc::Status StatusOfUntakenAnswer() {
  return {grpc::StatusCode::CANCELLED, "the answer was not taken in time (--max-transfer-s)"};
}

grpc::Status StatusOfUnsentAnswer() {
  return {grpc::StatusCode::CANCELLED,
          "the answer was not taken, and too many wait (--max-unsent-mib)"};
}

void AddRetryAfter(std::chrono::milliseconds wait, grpc::ServerContext* context) {
  const std::string text = std::to_string(wait.count());
  context->AddTrailingMetadata("retry-after-ms", text);
  context->AddTrailingMetadata("grpc-retry-pushback-ms", text);
}

const char* NameOf(grpc::StatusCode code) {
  // In the order of their numbers.
  static constexpr std::array kNames{"OK",
                                     "CANCELLED",
                                     "UNKNOWN",
                                     "INVALID_ARGUMENT",
                                     "DEADLINE_EXCEEDED",
                                     "NOT_FOUND",
                                     "ALREADY_EXISTS",
                                     "PERMISSION_DENIED",
                                     "RESOURCE_EXHAUSTED",
                                     "FAILED_PRECONDITION",
                                     "ABORTED",
                                     "OUT_OF_RANGE",
                                     "UNIMPLEMENTED",
                                     "INTERNAL",
                                     "UNAVAILABLE",
                                     "DATA_LOSS",
                                     "UNAUTHENTICATED"};
  const auto number = static_cast<std::size_t>(code);
  return number < kNames.size() ? kNames[number] : "UNKNOWN";
}

}  // namespace fovea::server
