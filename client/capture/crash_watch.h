#pragma once

#include <string>

namespace fovea::capture {

// The reader of OpenNI2 crashes at some damaged recordings, anywhere between opening and the last
// frame. Goes on in a child process, and returns there alone: this one passes signals on to it and
// ends as it does; throws CameraError, which names the recording, where it crashes. Before there
// are threads, which the child would not have.
void GoOnWatched(const std::string& recording);

}  // namespace fovea::capture
