#pragma once

#include <chrono>

namespace fovea::capture {

// From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE only ask for a clean end, and a file that may not
// grow is an error of whoever writes it.
void CatchStopSignals();
bool StopAsked();
// Whether SIGINT or SIGTERM has come some time after another of them: what is under way is not
// waited for.
bool StopDemanded();
// Waits so long, or until one of them asks; whether one did.
bool StopAskedWithin(std::chrono::milliseconds time);

}  // namespace fovea::capture
