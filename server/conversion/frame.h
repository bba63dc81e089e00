#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/lens/lens.h"
#include "core/types/rgbd_frame.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// Checks and decodes the frame of a request, takes the distortion out of its images and registers
// its depth to colour where it says that this is to be done. `messages`, if given, receives for
// people what is odd and what was lost on the way, `lens` that of colour, if it has one: answers
// must go back by it (core/lens/distort_answer.h). Throws std::invalid_argument that starts with
// the path of the field, for example "frame.depth.data: …".
RgbdFrame FromProto(const v1::Frame& frame, std::uint64_t max_pixels,
                    std::vector<std::string>* messages = nullptr,
                    std::optional<Lens>* lens = nullptr);

}  // namespace fovea::server
