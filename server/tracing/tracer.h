#pragma once

#include <grpcpp/support/status.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "core/types/detections.h"
#include "server/tracing/trace_context.h"
#include "server/tracing/trace_exporter.h"

namespace fovea::server {

// A frame that has been answered.
struct TracedFrame {
  const std::string& robot;
  const std::string& request_id;
  const std::string& frame_id;
  const std::optional<TraceContext>& parent;  // of the call
  const grpc::Status& status;
  const Detections& detections;  // where the status is not OK, only times of stages
  std::chrono::nanoseconds took{};
};

// Makes spans of frames: one from the receipt to the answer, and in it one for each stage, "queue"
// and "decode" included.
class Tracer {
 public:
  // Frames whose caller sends no traceparent are traced with the probability `share`, the others
  // where the caller records its part.
  Tracer(const std::string& endpoint, double share);

  // Thread-safe; takes some microseconds.
  void OnFrame(const TracedFrame& frame);

  const TraceExporter& exporter() const { return exporter_; }

 private:
  const double share_;
  TraceExporter exporter_;
};

// The spans of a frame that was answered `now`: the stages follow each other from its receipt on.
FrameSpans SpansOf(const TracedFrame& frame, Span::Time now);

}  // namespace fovea::server
