#pragma once

#include <chrono>

namespace fovea::capture {

// From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE only ask for a clean end, and a file that may not
// grow is an error of whoever writes it.
void CatchStopSignals();
bool StopAsked();
// Waits so long, or until one of them asks; whether one did.
bool StopAskedWithin(std::chrono::milliseconds time);

}  // namespace fovea::capture
