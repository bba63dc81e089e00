#pragma once

#include <grpcpp/support/status.h>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::server {

// Of a frame of a stream for which there was no room.
grpc::Status StatusOfNoRoom();

// Of a stream that has lasted for long enough: its caller is to open another one, at once.
grpc::Status StatusOfGreatAge();

void SetError(const grpc::Status& status, v1::DetectStreamResponse* response);

}  // namespace fovea::server
