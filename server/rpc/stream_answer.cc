#include "server/rpc/stream_answer.h"

#include <google/protobuf/util/time_util.h>

#include <chrono>
#include <memory>

#include "server/error_details.h"

namespace fovea::server {

grpc::Status StatusOfNoRoom() {
  return ResourceExhausted(
      "more frames wait in streams than there is room for (--max-receiving-mib)",
      std::chrono::seconds(1));
}

grpc::Status StatusOfGreatAge() {
  return WithRetryInfo(grpc::StatusCode::UNAVAILABLE,
                       "the stream has reached its greatest age; open another one",
                       std::chrono::milliseconds(0));
}

void SetError(const grpc::Status& status, v1::DetectStreamResponse* response) {
  auto error = std::make_unique<v1::FrameError>();  // all of it or, without memory, none
  error->set_code(status.error_code());
  error->set_message(status.error_message());
  error->set_field(FieldOf(status));
  if (const auto retry_after = RetryAfterOf(status)) {
    *error->mutable_retry_after() =
        google::protobuf::util::TimeUtil::MillisecondsToDuration(retry_after->count());
  }
  response->set_allocated_error(error.release());
}

}  // namespace fovea::server
