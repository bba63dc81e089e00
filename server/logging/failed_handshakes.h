// gRPC says that a handshake has failed, and not whose.
#pragma once

namespace fovea::server {

void NoteFailedHandshake();

// Whether there was one more than this was asked for.
bool TakeFailedHandshake();

}  // namespace fovea::server
