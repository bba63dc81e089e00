#pragma once

#include <array>
#include <cstdint>

#include "core/types/color.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

v1::Color ColorToProto(const std::array<std::uint8_t, 3>& rgb);

v1::ColorPart ToProto(const ColorPart& part);

}  // namespace fovea::server
