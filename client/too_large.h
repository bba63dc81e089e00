#pragma once

#include <grpcpp/support/status.h>

namespace fovea::client {

// gRPC's "larger than max (SIZE vs. MOST)" says neither which message that is nor what helps: the
// same status in words that do. Others as they are. max_answer_mib: of this client.
grpc::Status SayingWhatIsTooLarge(const grpc::Status& status, int max_answer_mib);

}  // namespace fovea::client
