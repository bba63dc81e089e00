#pragma once

#include "core/trace.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::server {

// Whether the answer needs the detector's intermediate results.
bool WantsTrace(const v1::DetectOptions& options);

// Adds those of them that `options` asks for. `trace` may be empty where WantsTrace is false.
void AddTrace(const Trace& trace, const v1::DetectOptions& options, v1::Detections* proto);

}  // namespace fovea::server
