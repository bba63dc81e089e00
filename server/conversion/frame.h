#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/types/rgbd_frame.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// Checks and decodes the frame of a request, and registers its depth to colour where it says that
// this is to be done. `messages`, if given, receives for people what was lost on the way. Throws
// std::invalid_argument that starts with the path of the field, for example "frame.depth.data: …".
RgbdFrame FromProto(const v1::Frame& frame, std::uint64_t max_pixels,
                    std::vector<std::string>* messages = nullptr);

}  // namespace fovea::server
