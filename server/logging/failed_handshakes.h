// gRPC says that a handshake has failed, and not whose: the connection that ends next is taken for
// it, where it ends soon.
#pragma once

#include <chrono>

namespace fovea::server {

using HandshakeClock = std::chrono::steady_clock;

void NoteFailedHandshake(HandshakeClock::time_point now = HandshakeClock::now());

// Whether there was one more than this was asked for, less than a second ago: one whose connection
// ended before gRPC said so is nobody else's.
bool TakeFailedHandshake(HandshakeClock::time_point now = HandshakeClock::now());

}  // namespace fovea::server
