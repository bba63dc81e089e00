#include "client/rpc_error.h"

#include <google/protobuf/any.pb.h>
#include <google/protobuf/unknown_field_set.h>

#include <array>
#include <utility>
#include <vector>

namespace fovea::client {
namespace {

// In the order of their numbers.
constexpr std::array kCodeNames{
    "OK",        "CANCELLED",      "UNKNOWN",           "INVALID_ARGUMENT",   "DEADLINE_EXCEEDED",
    "NOT_FOUND", "ALREADY_EXISTS", "PERMISSION_DENIED", "RESOURCE_EXHAUSTED", "FAILED_PRECONDITION",
    "ABORTED",   "OUT_OF_RANGE",   "UNIMPLEMENTED",     "INTERNAL",           "UNAVAILABLE",
    "DATA_LOSS", "UNAUTHENTICATED"};

std::string TextOf(const grpc::Status& status, const std::string& request_id) {
  const auto code = static_cast<std::size_t>(status.error_code());
  const char* name = code < kCodeNames.size() ? kCodeNames[code] : "UNKNOWN";
  const std::string text = name + std::string(": ") + status.error_message();
  return request_id.empty() ? text : text + " (request " + request_id + ")";
}

using google::protobuf::UnknownField;
using google::protobuf::UnknownFieldSet;

// The strings, or messages as bytes, of this number in a serialized message.
std::vector<std::string> Parts(const std::string& bytes, int number) {
  UnknownFieldSet fields;
  std::vector<std::string> parts;
  if (!fields.ParseFromString(bytes)) return parts;
  for (int i = 0; i < fields.field_count(); ++i) {
    const UnknownField& field = fields.field(i);
    const bool is_wanted =
        field.number() == number && field.type() == UnknownField::TYPE_LENGTH_DELIMITED;
    if (is_wanted) parts.push_back(field.length_delimited());
  }
  return parts;
}

// Of the first google.rpc.BadRequest in the details of a google.rpc.Status. Read by the numbers of
// the fields: with generated classes of our own, programs that bring theirs would not start.
std::string FieldOf(const std::string& status_details) {
  constexpr int kDetails = 3, kViolations = 1, kField = 1;
  for (const std::string& detail : Parts(status_details, kDetails)) {
    google::protobuf::Any any;
    if (!any.ParseFromString(detail) || !any.type_url().ends_with("/google.rpc.BadRequest"))
      continue;
    for (const std::string& violation : Parts(any.value(), kViolations)) {
      for (std::string& field : Parts(violation, kField)) return std::move(field);
    }
  }
  return "";
}

}  // namespace

RpcError::RpcError(const grpc::Status& status, std::optional<std::chrono::milliseconds> retry_after,
                   std::string request_id)
    : std::runtime_error(TextOf(status, request_id)),
      code_(status.error_code()),
      message_(status.error_message()),
      field_(FieldOf(status.error_details())),
      retry_after_(retry_after),
      request_id_(std::move(request_id)) {}

}  // namespace fovea::client
