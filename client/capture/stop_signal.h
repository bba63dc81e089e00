#pragma once

#include <chrono>

namespace fovea::capture {

// From now on SIGINT and SIGTERM only ask for a clean end.
void CatchStopSignals();
bool StopAsked();
// Waits so long, or until one of them asks; whether one did.
bool StopAskedWithin(std::chrono::milliseconds time);

}  // namespace fovea::capture
