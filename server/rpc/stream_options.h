#pragma once

#include <grpcpp/support/status.h>

#include <string>

#include "fovea/v1/detection_service.pb.h"
#include "server/rpc/newest_frame.h"

namespace fovea::server {

// The options of a stream: what a message says holds for its frame and those after it until another
// one says something else, dropped frames among them. Not thread-safe.
class StreamOptions {
 public:
  // Parses the message of a frame. Where there is no memory for it its options hold all the same,
  // and what was thrown goes on.
  grpc::Status Parse(ReceivedFrame* received, v1::DetectStreamRequest* request);

  // Gives a message that was parsed, or for which there was no room, the options that hold for it.
  void Complete(const ReceivedFrame& received, v1::DetectStreamRequest* request);

 private:
  std::string newest_;  // that were given, in few bytes
};

}  // namespace fovea::server
