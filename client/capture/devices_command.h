#pragma once

namespace fovea::capture {

// Prints the cameras that OpenNI2 sees, as --device takes them, with their names and modes. Returns
// the exit code; throws CameraError where there is none.
int RunDevices();

}  // namespace fovea::capture
