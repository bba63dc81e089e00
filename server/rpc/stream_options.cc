#include "server/rpc/stream_options.h"

#include <optional>
#include <utility>

#include "server/rpc/option_bytes.h"
#include "server/rpc/parse.h"

namespace fovea::server {

grpc::Status StreamOptions::Parse(ReceivedFrame* received, v1::DetectStreamRequest* request) {
  std::optional<std::string> given = OptionBytesOf(received->bytes);
  try {
    return server::Parse(&received->bytes, request);
  } catch (...) {
    std::optional<std::string>& newest = given ? given : received->options;
    if (newest && v1::DetectOptions().ParseFromString(*newest)) newest_ = std::move(*newest);
    throw;
  }
}

void StreamOptions::Complete(const ReceivedFrame& received, v1::DetectStreamRequest* request) {
  if (request->has_options()) {
    newest_ = request->options().SerializeAsString();
    return;
  }
  v1::DetectOptions& options = *request->mutable_options();
  if (received.options && options.ParseFromString(*received.options)) {
    newest_ = *received.options;
  } else {
    options.ParseFromString(newest_);
  }
}

}  // namespace fovea::server
