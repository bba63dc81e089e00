#include "client/rpc_error.h"

#include <array>

namespace fovea::client {
namespace {

// In the order of their numbers.
constexpr std::array kCodeNames{
    "OK",        "CANCELLED",      "UNKNOWN",           "INVALID_ARGUMENT",   "DEADLINE_EXCEEDED",
    "NOT_FOUND", "ALREADY_EXISTS", "PERMISSION_DENIED", "RESOURCE_EXHAUSTED", "FAILED_PRECONDITION",
    "ABORTED",   "OUT_OF_RANGE",   "UNIMPLEMENTED",     "INTERNAL",           "UNAVAILABLE",
    "DATA_LOSS", "UNAUTHENTICATED"};

std::string TextOf(const grpc::Status& status) {
  const auto code = static_cast<std::size_t>(status.error_code());
  const char* name = code < kCodeNames.size() ? kCodeNames[code] : "UNKNOWN";
  return name + std::string(": ") + status.error_message();
}

}  // namespace

RpcError::RpcError(const grpc::Status& status, std::optional<std::chrono::milliseconds> retry_after)
    : std::runtime_error(TextOf(status)),
      code_(status.error_code()),
      message_(status.error_message()),
      retry_after_(retry_after) {}

}  // namespace fovea::client
