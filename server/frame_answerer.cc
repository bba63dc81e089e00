#include "server/frame_answerer.h"

#include <string>
#include <utility>

#include "server/conversion/detections.h"
#include "server/conversion/field_error.h"
#include "server/conversion/frame.h"
#include "server/conversion/options.h"
#include "server/rpc/caller.h"
#include "server/status.h"
#include "server/watching/metrics.h"
#include "server/watching/request_log.h"

namespace fovea::server {
namespace {

using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void Log(const FrameRequest& request, const grpc::Status& status, int num_objects) {
  LogFrame(request.frame != nullptr ? request.frame->id() : "", status,
           static_cast<std::size_t>(num_objects), Clock::now() - request.received);
}

}  // namespace

FrameAnswerer::FrameAnswerer(DetectFunction detect, std::int64_t max_pixels, Metrics& metrics)
    : detect_(std::move(detect)),
      max_pixels_(static_cast<std::uint64_t>(max_pixels)),
      metrics_(metrics) {}

grpc::Status FrameAnswerer::Answer(const FrameRequest& request, const Caller& caller,
                                   v1::Detections* answer) const {
  grpc::Status status;
  Detections detections;
  try {
    if (caller.IsGone()) throw Cancelled();
    RequireField(request.frame != nullptr, "frame", "is missing");
    Trace trace;
    detections = Compute(request, caller, &trace);
    *answer = ToProto(detections, trace, *request.frame, *request.options);
  } catch (...) {
    status = StatusOfCurrentException(caller.DeadlinePassed());
  }
  Log(request, status, answer->objects_size());
  metrics_.OnAnswered(status, status.ok() ? &detections : nullptr);
  return status;
}

void FrameAnswerer::Refuse(const FrameRequest& request, const grpc::Status& status) const {
  Log(request, status, 0);
  metrics_.OnAnswered(status, nullptr);
}

Detections FrameAnswerer::Compute(const FrameRequest& request, const Caller& caller,
                                  Trace* trace) const {
  const double queue_ms = MillisecondsSince(request.received);
  const DetectorOptions options = FromProto(*request.options);
  const Clock::time_point start = Clock::now();
  const RgbdFrame frame = FromProto(*request.frame, max_pixels_);
  const double decode_ms = MillisecondsSince(start);
  try {
    Detections detections = detect_(frame, options, WantsTrace(*request.options) ? trace : nullptr,
                                    [&caller] { return caller.IsGone(); });
    detections.stage_times.insert(detections.stage_times.begin(),
                                  {{"queue", queue_ms}, {"decode", decode_ms}});
    return detections;
  } catch (const std::invalid_argument& error) {
    // Options were validated before: what the core still finds is about the frame.
    throw std::invalid_argument("frame." + std::string(error.what()));
  }
}

}  // namespace fovea::server
