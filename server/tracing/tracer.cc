#include "server/tracing/tracer.h"

#include <utility>

#include "server/compute_limit.h"
#include "server/status.h"

namespace fovea::server {
namespace {

std::chrono::nanoseconds Nanoseconds(double duration_ms) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double, std::milli>(duration_ms));
}

Span FrameSpan(const TracedFrame& frame, Span::Time now) {
  Span span{.name = "fovea.frame",
            .trace_id = frame.parent ? frame.parent->trace_id : RandomTraceId(),
            .id = RandomSpanId(),
            .parent = std::nullopt,
            .is_call = true,
            .start = now - frame.took,
            .end = now,
            .attributes = {{"fovea.robot", frame.robot},
                           {"fovea.request_id", frame.request_id},
                           {"fovea.frame_id", frame.frame_id},
                           {"rpc.system", "grpc"},
                           {"rpc.grpc.status_code", std::int64_t{frame.status.error_code()}}},
            .error = std::nullopt};
  if (frame.parent) span.parent = frame.parent->parent;
  if (frame.status.ok()) {
    span.attributes.emplace_back("fovea.objects",
                                 static_cast<std::int64_t>(frame.detections.objects.size()));
  } else {
    span.error =
        std::string(NameOf(frame.status.error_code())) + ": " + frame.status.error_message();
  }
  return span;
}

}  // namespace

FrameSpans SpansOf(const TracedFrame& frame, Span::Time now) {
  FrameSpans spans{FrameSpan(frame, now)};
  const Span whole = spans.front();
  Span::Time at = whole.start;
  for (const StageTime& stage : frame.detections.stage_times) {
    if (stage.stage == kProcessorWait) continue;  // it is in the others
    const Span::Time start = at;
    at += Nanoseconds(stage.duration_ms);
    spans.push_back({.name = stage.stage,
                     .trace_id = whole.trace_id,
                     .id = RandomSpanId(),
                     .parent = whole.id,
                     .is_call = false,
                     .start = start,
                     .end = at,
                     .attributes = {},
                     .error = std::nullopt});
  }
  return spans;
}

Tracer::Tracer(const std::string& endpoint, double share)
    : share_(share), exporter_(ParseHttpUrl("--trace-endpoint", endpoint)) {}

void Tracer::OnFrame(const TracedFrame& frame) {
  const bool wanted = frame.parent ? frame.parent->sampled : RandomShare() < share_;
  if (wanted && !frame.robot.empty()) {
    exporter_.Add(SpansOf(frame, std::chrono::system_clock::now()));
  }
}

}  // namespace fovea::server
