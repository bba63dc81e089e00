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
  for (const std::string_view part : {"frame", "options"}) {
    if (path == part || (path.starts_with(part) && path[part.size()] == '.')) return true;
  }
  return false;
}

// Where the path in front of a text ends; npos where there is none. Names in brackets come from the
// caller and may hold anything.
std::size_t EndOfPath(const std::string& text) {
  const std::size_t colon = text.find(": ");
  if (text.find('[') >= colon) return colon;
  const std::size_t bracket = text.find("]: ");
  return bracket == std::string::npos ? bracket : bracket + 1;
}

}  // namespace

grpc::Status InvalidArgument(const std::string& text) {
  const std::size_t end = EndOfPath(text);
  std::string path = text.substr(0, end);
  if (end == std::string::npos || !IsOfRequest(path)) {
    return {grpc::StatusCode::INVALID_ARGUMENT, text};
  }
  google::rpc::BadRequest detail;
  google::rpc::BadRequest::FieldViolation& violation = *detail.add_field_violations();
  violation.set_description(text.substr(end + 2));
  const bool is_name = path.ends_with(']');
  // The first of "frame.color.width, height".
  violation.set_field(is_name ? path : path.substr(0, path.find(", ")));
  return Detailed(grpc::StatusCode::INVALID_ARGUMENT, text, detail);
}

grpc::Status ResourceExhausted(const std::string& text, std::chrono::milliseconds retry_after) {
  google::rpc::RetryInfo detail;
  *detail.mutable_retry_delay() = TimeUtil::MillisecondsToDuration(retry_after.count());
  return Detailed(grpc::StatusCode::RESOURCE_EXHAUSTED, text, detail);
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
