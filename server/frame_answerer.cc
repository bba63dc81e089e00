#include "server/frame_answerer.h"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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

}  // namespace

FrameAnswerer::FrameAnswerer(DetectFunction detect, const ServerOptions& options, Metrics& metrics)
    : detect_(std::move(detect)),
      max_pixels_(static_cast<std::uint64_t>(options.max_pixels)),
      slow_(options.slow_ms),
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
    detections = {};
  }
  Record(request, caller, status, detections);
  return status;
}

void FrameAnswerer::Refuse(const FrameRequest& request, const Caller& caller,
                           const grpc::Status& status) const {
  Record(request, caller, status, {});
}

void FrameAnswerer::Record(const FrameRequest& request, const Caller& caller,
                           const grpc::Status& status, const Detections& detections) const {
  const Clock::duration took = Clock::now() - request.received;
  const std::string frame_id = request.frame != nullptr ? request.frame->id() : "";
  LogFrame({.request_id = caller.request_id(),
            .robot = caller.robot(),
            .frame_id = frame_id,
            .status = status,
            .detections = detections,
            .took = took},
           slow_);
  metrics_.OnAnswered(caller.robot(), status, detections, took);
}

Detections FrameAnswerer::Compute(const FrameRequest& request, const Caller& caller,
                                  Trace* trace) const {
  const double queue_ms = MillisecondsSince(request.received);
  const DetectorOptions options = FromProto(*request.options);
  const Clock::time_point start = Clock::now();
  std::vector<std::string> losses;
  const RgbdFrame frame = FromProto(*request.frame, max_pixels_, &losses);
  const double decode_ms = MillisecondsSince(start);
  InField("options.parameters", [&] { RequireNotEmpty(options.region, frame.depth_m.size()); });
  try {
    Detections detections = detect_(frame, options, WantsTrace(*request.options) ? trace : nullptr,
                                    [&caller] { return caller.IsGone(); });
    std::vector<std::string>& messages = detections.diagnostics.messages;
    messages.insert(messages.begin(), losses.begin(), losses.end());
    detections.stage_times.insert(detections.stage_times.begin(),
                                  {{"queue", queue_ms}, {"decode", decode_ms}});
    return detections;
  } catch (const std::invalid_argument& error) {
    // Options were validated before: what the core still finds is about the frame.
    throw std::invalid_argument("frame." + std::string(error.what()));
  } catch (const std::length_error& error) {
    // A limit of the method, for this frame with these options.
    throw std::invalid_argument(error.what());
  }
}

}  // namespace fovea::server
