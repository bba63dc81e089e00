#pragma once

namespace fovea::capture {

// From now on SIGINT and SIGTERM only ask for a clean end.
void CatchStopSignals();
bool StopAsked();

}  // namespace fovea::capture
