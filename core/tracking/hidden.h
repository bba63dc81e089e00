// Why a track is not seen.
#pragma once

#include "core/tracking/sighting.h"
#include "core/types/rgbd_frame.h"
#include "core/types/track.h"

namespace fovea {

// By what the frame measures where the points of the thing should be: the reason that holds for
// more than half of them, kNotDetected where none does.
HiddenReason ReasonOf(const Sighting& expected, const RgbdFrame& frame);

}  // namespace fovea
