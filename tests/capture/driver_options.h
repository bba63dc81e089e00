// What the test camera shall do: set by the environment of the process that loads it.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace fovea::testing {

// FOVEA_CAMERA_FRAMES   folder with NAME_color.png and NAME_depth.png, served in turn for ever
// FOVEA_CAMERA_FPS      frames a second; 0 (default) = as fast as they are read
// FOVEA_CAMERA_FAULTS   words, separated by commas:
//   no-device           nothing is plugged in
//   denied              opening fails as it does without permission
//   no-registration     depth cannot be registered
//   late-registration   registration works only once the streams run
//   silent              no frame ever arrives
//   hangs               the camera delivers three frames; opened a second time it delivers none,
//   then
//                       all
//   wrong-size          images are half as wide and high as set
//   half                half of each fourth depth image arrives
//   drop-color          each fourth colour image is missing
//   color-waits         each colour image comes with the next look at the camera only
//   late-color          each fourth colour image arrives after the next depth image
// FOVEA_CAMERA_CONTROL  a file: while it exists, the camera is unplugged
struct DriverOptions {
  std::string frames, control;
  int fps = 0;
  std::set<std::string> faults;

  bool Has(const std::string& fault) const { return faults.contains(fault); }
};

DriverOptions ReadDriverOptions();

}  // namespace fovea::testing
