#pragma once

#include "fovea/v1/detection_service.grpc.pb.h"
#include "server/frame_answerer.h"
#include "server/rpc/live_calls.h"
#include "server/scheduling/scheduler.h"
#include "server/watching/metrics.h"

namespace fovea::server {

// Frames are answered asynchronously, so that what waits holds no thread. Streams come as raw
// bytes: a message that cannot be parsed shall not end them.
using DetectionService = v1::DetectionService::WithAsyncMethod_Detect<
    v1::DetectionService::WithRawMethod_DetectStream<v1::DetectionService::Service>>;

// What a call works with; outlives all calls.
struct CallEnvironment {
  DetectionService& service;
  grpc::ServerCompletionQueue* queue;
  Scheduler& scheduler;
  const FrameAnswerer& answerer;
  LiveCalls& live_calls;
  Metrics& metrics;
};

}  // namespace fovea::server
