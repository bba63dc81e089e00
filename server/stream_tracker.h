// The identities of one stream's objects.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/tracking/tracker.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"
#include "fovea/v1/detection.pb.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// A stream's own, so that no robot's tracks depend on another's; it ends with the stream, and holds
// some 1.3 MB at most. Not thread-safe: a stream has one frame in work at any time, and the
// scheduler hands it from thread to thread.
class StreamTracker {
 public:
  // Tracks the objects of a frame where `options` wants that, and forgets all others where it does
  // not, or wants a reset. The time it takes becomes the stage "tracking" of `times`.
  void Add(const v1::Frame& proto, const v1::TrackingOptions& options, const RgbdFrame& frame,
           Detections& detections, std::vector<StageTime>* times);

 private:
  std::optional<Tracker> tracker_;
  std::uint32_t reset_ = 0;  // of the frame before
};

// Throws std::invalid_argument where tracking is asked for and there is no stream.
void RequireStream(const v1::DetectOptions& options, const StreamTracker* tracker);

}  // namespace fovea::server
