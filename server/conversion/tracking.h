// Identities over the frames of a stream, as messages.
#pragma once

#include "core/tracking/tracker.h"
#include "core/types/detections.h"
#include "fovea/v1/detection.pb.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// The pose and time of a frame. Throws std::invalid_argument that starts with "frame.camera_pose".
FrameContext ContextOf(const v1::Frame& frame);

// Fill the fields of tracking; nothing where there was none.
void AddTrack(const DetectedObject& object, v1::Object* proto);
void AddTracking(const Detections& detections, v1::Detections* proto);

}  // namespace fovea::server
