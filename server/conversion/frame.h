#pragma once

#include <cstdint>

#include "core/types/rgbd_frame.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// Checks and decodes the frame of a request. Throws std::invalid_argument that starts with the
// path of the field, for example "frame.depth.data: …".
RgbdFrame FromProto(const v1::Frame& frame, std::uint64_t max_pixels);

}  // namespace fovea::server
