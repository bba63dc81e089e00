// What other cameras, and what lies between a camera and the detector, do to frames: shows on
// recorded scenes how far results depend on the camera that recorded them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea::evaluation {

struct CameraEffect {
  std::string name;
  std::string description;
};

// All effects, in the order in which reports show them.
const std::vector<CameraEffect>& CameraEffects();

// Returns the frame as it would be with the effect on top of what its own camera did; the input
// stays as it is. The same seed gives the same bytes. Throws std::invalid_argument for a name that
// is not in CameraEffects.
RgbdFrame WithCameraEffect(const RgbdFrame& frame, const std::string& name, std::uint64_t seed);

}  // namespace fovea::evaluation
