#pragma once

#include "core/trace.h"
#include "core/types/detections.h"
#include "fovea/v1/detection.pb.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// The answer to `frame`, with what `options` asks for. Masks, clouds and the pose in the
// reference frame follow the request; `trace` may be empty where WantsTrace is false.
v1::Detections ToProto(const Detections& detections, const Trace& trace, const v1::Frame& frame,
                       const v1::DetectOptions& options);

v1::StageTime ToProto(const StageTime& time);

}  // namespace fovea::server
