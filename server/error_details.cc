#include "server/error_details.h"

#include <google/protobuf/util/time_util.h>

#include <string_view>

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace fovea::server {
namespace {

using google::protobuf::util::TimeUtil;

grpc::Status Detailed(grpc::StatusCode code, const std::string& text,
                      const google::protobuf::Message& detail) {
  google::rpc::Status status;
  status.set_code(code);
  status.set_message(text);
  status.add_details()->PackFrom(detail);
  return {code, text, status.SerializeAsString()};
}

template <typename Detail>
std::optional<Detail> Find(const grpc::Status& status) {
  google::rpc::Status details;
  details.ParseFromString(status.error_details());
  for (const google::protobuf::Any& any : details.details()) {
    if (Detail detail; any.UnpackTo(&detail)) return detail;
  }
  return std::nullopt;
}

bool IsOfRequest(std::string_view path) {
  for (const std::string_view part :
       {"frame", "options", "robot", "pick", "robots", "max_rate_hz", "parts"}) {
    if (path == part || (path.starts_with(part) && path[part.size()] == '.')) return true;
  }
  return false;
}

}  // namespace

grpc::Status InvalidArgument(const FieldError& error) {
  const std::string_view path = error.path();
  if (!IsOfRequest(path)) return {grpc::StatusCode::INVALID_ARGUMENT, error.what()};
  google::rpc::BadRequest detail;
  google::rpc::BadRequest::FieldViolation& violation = *detail.add_field_violations();
  violation.set_description(std::string(error.message()));
  // The first of "frame.color.width, height".
  const bool has_name = path.find('[') != std::string_view::npos;
  violation.set_field(std::string(has_name ? path : path.substr(0, path.find(", "))));
  return Detailed(grpc::StatusCode::INVALID_ARGUMENT, error.what(), detail);
}

grpc::Status WithRetryInfo(grpc::StatusCode code, const std::string& text,
                           std::chrono::milliseconds retry_after) {
  google::rpc::RetryInfo detail;
  *detail.mutable_retry_delay() = TimeUtil::MillisecondsToDuration(retry_after.count());
  return Detailed(code, text, detail);
}

grpc::Status ResourceExhausted(const std::string& text, std::chrono::milliseconds retry_after) {
  return WithRetryInfo(grpc::StatusCode::RESOURCE_EXHAUSTED, text, retry_after);
}

std::string FieldOf(const grpc::Status& status) {
  const auto detail = Find<google::rpc::BadRequest>(status);
  if (!detail || detail->field_violations().empty()) return "";
  return detail->field_violations(0).field();
}

std::optional<std::chrono::milliseconds> RetryAfterOf(const grpc::Status& status) {
  const auto detail = Find<google::rpc::RetryInfo>(status);
  if (!detail) return std::nullopt;
  return std::chrono::milliseconds(TimeUtil::DurationToMilliseconds(detail->retry_delay()));
}

}  // namespace fovea::server
