#include "server/frame_answerer.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/lens/distort_answer.h"
#include "core/lens/undistortion.h"
#include "core/types/interruption.h"
#include "server/compute_limit.h"
#include "server/conversion/detections.h"
#include "server/conversion/field_error.h"
#include "server/conversion/frame.h"
#include "server/conversion/frame_notes.h"
#include "server/conversion/options.h"
#include "server/conversion/trace.h"
#include "server/log_exception.h"
#include "server/observing/watch_hub.h"
#include "server/rpc/caller.h"
#include "server/scheduling/thread_priority.h"
#include "server/status.h"
#include "server/stream_tracker.h"
#include "server/tracing/tracer.h"
#include "server/watching/metrics.h"
#include "server/watching/request_log.h"

namespace fovea::server {
namespace {

using Clock = std::chrono::steady_clock;

// Regions of interest are in the pixels that were sent, the detector looks at others.
void UndistortRegion(const Lens& lens, RegionOptions& region) {
  const cv::Rect sent(region.x_px, region.y_px,
                      region.width_px > 0 ? region.width_px : lens.size().width,
                      region.height_px > 0 ? region.height_px : lens.size().height);
  const cv::Rect image({0, 0}, lens.size());
  if ((sent & image) == image) return;
  const cv::Rect ideal = UndistortRect(lens, sent & image);
  region.x_px = ideal.x;
  region.y_px = ideal.y;
  region.width_px = ideal.width;
  region.height_px = ideal.height;
}

// Whose caller has left or was left by a server that stops: the call knows.
grpc::Status StatusOfException(const Caller& caller) {
  try {
    throw;
  } catch (const Cancelled&) {
    return caller.StatusOfGone();
  } catch (...) {
    return StatusOfCurrentException();
  }
}

double Milliseconds(Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

}  // namespace

FrameAnswerer::FrameAnswerer(DetectFunction detect, const ServerOptions& options, Metrics& metrics,
                             Tracer* tracer, WatchHub* watch_hub)
    : max_threads_per_frame_(MaxThreadsPerFrame(options)),
      helpers_(max_threads_per_frame_ > 1 ? NumComputeThreads(options) : 1,
               [nice = options.compute_nice] { LowerPriority(nice); }),
      detect_(std::move(detect)),
      policy_(options.client_options, options.fixed_options),
      grippers_(options.grippers),
      max_pixels_(static_cast<std::uint64_t>(options.max_pixels)),
      max_compute_(options.max_compute_ms),
      slow_(options.slow_ms),
      metrics_(metrics),
      tracer_(tracer),
      watch_hub_(watch_hub) {}

grpc::Status FrameAnswerer::Answer(const FrameRequest& request, const Caller& caller,
                                   v1::Detections* answer) const {
  grpc::Status status;
  Detections detections;
  RgbdFrame decoded;
  std::vector<StageTime> times;
  try {
    const Asker asker{.robot = caller.robot(), .is_gone = [&] { return caller.IsGone(); }};
    detections = AnswerOrThrow(request, asker, &decoded, &times, answer);
  } catch (...) {
    status = StatusOfException(caller);
    detections.stage_times = times;
  }
  Record(request, caller, status, detections, decoded.depth_m.size());
  Show(request, caller, status, detections, decoded, answer);
  return status;
}

grpc::Status FrameAnswerer::Try(const FrameRequest& request, const Asker& asker,
                                v1::Detections* answer) const {
  RgbdFrame decoded;
  std::vector<StageTime> times;
  try {
    AnswerOrThrow(request, asker, &decoded, &times, answer);
    return {};
  } catch (...) {
    return StatusOfCurrentException();
  }
}

void FrameAnswerer::Refuse(const FrameRequest& request, const Caller& caller,
                           const grpc::Status& status) const {
  Record(request, caller, status, {}, {});
  Show(request, caller, status, {}, {}, nullptr);
}

// The answer matters more than what is said of it elsewhere.
void FrameAnswerer::Record(const FrameRequest& request, const Caller& caller,
                           const grpc::Status& status, const Detections& detections,
                           cv::Size image) const noexcept try {
  const Clock::time_point now = Clock::now();
  const Clock::duration took = now - request.received;
  const Clock::time_point turn = request.began == Clock::time_point{} ? now : request.began;
  const std::string frame_id = request.frame != nullptr ? request.frame->id() : "";
  const std::string peer = caller.robot().empty() ? caller.peer() : "";
  LogFrame({.request_id = caller.request_id(),
            .robot = caller.robot(),
            .peer = peer,
            .frame_id = frame_id,
            .status = status,
            .detections = detections,
            .options = request.frame != nullptr ? request.options : nullptr,
            .image = image,
            .queued = turn - request.received,
            .took = took},
           slow_);
  metrics_.OnAnswered(caller.robot(), status, detections, took);
  if (tracer_ == nullptr) return;
  tracer_->OnFrame({.robot = caller.robot(),
                    .request_id = caller.request_id(),
                    .frame_id = frame_id,
                    .parent = caller.trace(),
                    .status = status,
                    .detections = detections,
                    .took = took});
} catch (...) {
  LogCurrentException("a frame that was answered is not counted");
}

void FrameAnswerer::Show(const FrameRequest& request, const Caller& caller,
                         const grpc::Status& status, const Detections& detections,
                         const RgbdFrame& decoded, const v1::Detections* answer) const noexcept
    try {
  if (watch_hub_ == nullptr || !watch_hub_->IsWatched() || caller.robot().empty()) return;
  watch_hub_->Show(caller.robot(), [&](WatchParts parts) {
    Sight sight{.robot = caller.robot(),
                .answered_at = std::chrono::system_clock::now(),
                .took = Clock::now() - request.received,
                .status = status,
                .options = *request.options,
                .decoded = decoded,
                .detections = detections};
    for (DetectedObject& object : sight.detections.objects) object.cloud = {};
    if (request.frame != nullptr) sight.frame = *request.frame;
    if (answer != nullptr) {
      *sight.extras.mutable_seeds() = answer->seeds();
      *sight.extras.mutable_saliency_maps() = answer->saliency_maps();
      sight.extras.set_grippers_source(answer->grippers_source());
      if ((parts & Bit(v1::WATCH_PART_FRAME)) != 0) {
        sight.answer = std::make_shared<const v1::Detections>(*answer);
      }
    }
    return sight;
  });
} catch (...) {
  LogCurrentException("a frame that was answered is not shown");
}

Detections FrameAnswerer::AnswerOrThrow(const FrameRequest& request, const Asker& asker,
                                        RgbdFrame* decoded, std::vector<StageTime>* times,
                                        v1::Detections* answer) const {
  times->push_back({"queue", Milliseconds(request.began - request.received)});
  if (asker.is_gone()) throw Cancelled();
  RequireField(request.frame != nullptr, "frame", "is missing");
  Trace trace;
  Detections detections = Compute(request, asker, &trace, decoded, times);
  detections.stage_times = *times;
  *answer = ToProto(detections, trace, *request.frame, *request.options);
  answer->set_grippers_source(grippers_.SourceFor(asker.robot, request.options->grasps()));
  return detections;
}

// All of it, decoding and lenses too, can be stopped and has one limit.
Detections FrameAnswerer::Compute(const FrameRequest& request, const Asker& asker, Trace* trace,
                                  RgbdFrame* decoded, std::vector<StageTime>* times) const {
  const ComputeLimit limit(max_compute_);
  bool passed = false;
  const auto should_stop = [&] {
    passed = limit.HasPassed();
    return passed || asker.is_gone();
  };
  const InterruptionScope interruption(should_stop);
  EnterStage("decode");
  try {
    return Compute(request, asker, {limit, should_stop}, trace, decoded, times);
  } catch (const Cancelled& cancelled) {
    times->insert(times->end(), cancelled.stage_times.begin(), cancelled.stage_times.end());
    if (passed && !asker.is_gone()) throw ComputeLimitPassed(cancelled.stage, max_compute_);
    throw;
  }
}

Detections FrameAnswerer::Compute(const FrameRequest& request, const Asker& asker, const End& end,
                                  Trace* trace, RgbdFrame* decoded,
                                  std::vector<StageTime>* times) const {
  std::vector<std::string> losses;
  DetectorOptions options = FromProto(*request.options, policy_);
  options.grippers = grippers_.For(asker.robot, request.options->grasps(), options.grippers);
  RequireStream(*request.options, request.tracker);
  std::optional<Lens> lens;
  const RgbdFrame frame = FromProto(*request.frame, max_pixels_, &losses, &lens);
  *decoded = frame;  // the images are shared
  RegionOptions& region = options.paper ? options.paper->region : options.region;
  InParameters([&] { RequireNotEmpty(region, frame.depth_m.size()); });
  if (lens) UndistortRegion(*lens, region);
  times->push_back({"decode", Milliseconds(Clock::now() - request.began)});
  // What the method throws from here on is no longer about the request, TooComplex apart.
  Detections detections;
  {
    std::optional<Helpers::Scope> helped;
    if (asker.is_helped) helped.emplace(helpers_, max_threads_per_frame_);
    detections =
        detect_(frame, options, WantsTrace(*request.options) ? trace : nullptr, end.should_stop);
  }
  times->insert(times->end(), detections.stage_times.begin(), detections.stage_times.end());
  times->push_back({kProcessorWait, Milliseconds(end.limit.WaitedForProcessor())});
  std::optional<InterruptionScope> whole;
  if (request.tracker != nullptr) {
    whole.emplace(nullptr);  // what the next ones' tracks hold was answered
    request.tracker->Add(*request.frame, request.options->tracking(), frame, detections, times);
  }
  if (const auto note = OddCameraPose(*request.frame, detections)) losses.push_back(*note);
  EnterStage("lens");
  if (lens) DistortAnswer(*lens, detections, *trace);
  std::vector<std::string>& messages = detections.diagnostics.messages;
  messages.insert(messages.begin(), losses.begin(), losses.end());
  return detections;
}

}  // namespace fovea::server
