#pragma once

#include "core/types/shape.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

v1::Shape ToProto(const Shape& shape);

}  // namespace fovea::server
