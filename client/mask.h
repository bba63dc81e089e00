#pragma once

#include <cstdint>
#include <vector>

#include "fovea/v1/detection.pb.h"

namespace fovea::client {

// The pixels of mask.bounds, row-major, 1 = object, 0 = background. Throws std::invalid_argument
// where the run lengths do not sum up to bounds.width * bounds.height, and for an object without a
// mask, as all are unless DetectOptions.return_masks asks for them.
std::vector<std::uint8_t> DecodeMask(const v1::Mask& mask);

}  // namespace fovea::client
