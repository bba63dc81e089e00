// What both RPCs do with a frame: decode, detect, convert, log, count.
#pragma once

#include <grpcpp/support/status.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/detector.h"
#include "core/types/helpers.h"
#include "fovea/v1/detection.pb.h"
#include "fovea/v1/frame.pb.h"
#include "server/compute_limit.h"
#include "server/conversion/option_policy.h"
#include "server/conversion/robot_grippers.h"
#include "server/server_options.h"

namespace fovea::server {

// Has the contract of fovea::Detect; tests put their own here.
using DetectFunction = std::function<Detections(const RgbdFrame&, const DetectorOptions&, Trace*,
                                                const std::function<bool()>& should_stop)>;

class Caller;
class Metrics;
class StreamTracker;
class Tracer;
class WatchHub;

// One frame that is to be answered; null where the request has none.
struct FrameRequest {
  const v1::Frame* frame = nullptr;
  const v1::DetectOptions* options = &v1::DetectOptions::default_instance();
  std::chrono::steady_clock::time_point received;
  std::chrono::steady_clock::time_point began{};  // its turn, parsing included
  StreamTracker* tracker = nullptr;  // of the stream that it is a frame of; null: it is alone
};

// Whom a frame is computed for.
struct Asker {
  const std::string& robot;
  std::function<bool()> is_gone;
  bool is_helped = true;  // by threads that have nothing to do
};

// Thread-safe.
class FrameAnswerer {
 public:
  // `metrics`, and `tracer` and `watch_hub`, which may be null, must outlive it.
  FrameAnswerer(DetectFunction detect, const ServerOptions& options, Metrics& metrics,
                Tracer* tracer = nullptr, WatchHub* watch_hub = nullptr);

  // Fills `answer` where the status is OK. Stops once the caller is gone, or
  // the limit of computing has passed.
  grpc::Status Answer(const FrameRequest& request, const Caller& caller,
                      v1::Detections* answer) const;

  // Fills `answer` as Answer() would for this robot where the status is OK, and leaves no trace: it
  // is not logged, counted, tracked or shown, and no helper threads work for it.
  grpc::Status Try(const FrameRequest& request, const Asker& asker, v1::Detections* answer) const;

  // Logs and counts a frame that is answered without being looked at.
  void Refuse(const FrameRequest& request, const Caller& caller, const grpc::Status& status) const;

 private:
  void Record(const FrameRequest& request, const Caller& caller, const grpc::Status& status,
              const Detections& detections, cv::Size image) const noexcept;
  // When a frame is given up.
  struct End {
    const ComputeLimit& limit;
    std::function<bool()> should_stop;
  };
  // Shows it to those who watch; `answer` is null where there is none.
  void Show(const FrameRequest& request, const Caller& caller, const grpc::Status& status,
            const Detections& detections, const RgbdFrame& decoded,
            const v1::Detections* answer) const noexcept;
  // `decoded` gets the frame once that is decoded, `times` those of the stages that it
  // came through, whether it throws or not.
  Detections AnswerOrThrow(const FrameRequest& request, const Asker& asker, RgbdFrame* decoded,
                           std::vector<StageTime>* times, v1::Detections* answer) const;
  Detections Compute(const FrameRequest& request, const Asker& asker, Trace* trace,
                     RgbdFrame* decoded, std::vector<StageTime>* times) const;
  Detections Compute(const FrameRequest& request, const Asker& asker, const End& end, Trace* trace,
                     RgbdFrame* decoded, std::vector<StageTime>* times) const;

  // Its compute threads help each other while some have nothing to do.
  const int max_threads_per_frame_;
  mutable Helpers helpers_;
  const DetectFunction detect_;
  const OptionPolicy policy_;
  const RobotGrippers grippers_;
  const std::uint64_t max_pixels_;
  const std::chrono::milliseconds max_compute_, slow_;
  Metrics& metrics_;
  Tracer* const tracer_;
  WatchHub* const watch_hub_;
};

}  // namespace fovea::server
