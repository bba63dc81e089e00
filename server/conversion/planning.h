#pragma once

#include "core/types/planning.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

v1::CollisionPrimitive ToProto(const CollisionPrimitive& primitive);
v1::HeightMap ToProto(const HeightMap& map);

// Throws std::invalid_argument that starts with the path of the field.
PlanningOptions PlanningFromProto(const v1::DetectOptions& options);

}  // namespace fovea::server
