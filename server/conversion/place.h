#pragma once

#include <optional>

#include "core/types/detections.h"
#include "core/types/place.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

v1::FreePlace ToProto(const FreePlace& place);

// What to find places for; none where `options` does not ask. Throws std::invalid_argument that
// starts with the path of the field.
std::optional<PlaceOptions> PlaceFromProto(const v1::DetectOptions& options);

}  // namespace fovea::server
