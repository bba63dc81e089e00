// The RPCs of fovea.v1.DetectionService around the detector.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "core/detector.h"
#include "fovea/v1/detection_service.grpc.pb.h"
#include "server/compute_slots.h"

namespace fovea::server {

// Has the contract of fovea::Detect; tests put their own here.
using DetectFunction = std::function<Detections(const RgbdFrame&, const DetectorOptions&, Trace*,
                                                const std::function<bool()>& should_stop)>;

// Thread-safe: gRPC calls it from a thread per call.
class DetectionService final : public v1::DetectionService::Service {
 public:
  DetectionService(DetectFunction detect, std::int64_t max_pixels, int max_concurrent);

  grpc::Status Detect(grpc::ServerContext* context, const v1::DetectRequest* request,
                      v1::DetectResponse* response) override;

  using Stream = grpc::ServerReaderWriter<v1::DetectStreamResponse, v1::DetectStreamRequest>;
  grpc::Status DetectStream(grpc::ServerContext* context, Stream* stream) override;

  // From now on streams end after the answer they are at.
  void EndStreams() { streams_end_ = true; }

 private:
  // Decodes, detects and converts one frame; fills `detections` where the status is OK. Where
  // `frame` is null, the status says so. Logs.
  grpc::Status Answer(const grpc::ServerContext& context, const v1::Frame* frame,
                      const v1::DetectOptions& options, v1::Detections* detections);

  v1::Detections Compute(const grpc::ServerContext& context, const v1::Frame& frame,
                         const v1::DetectOptions& options);

  const DetectFunction detect_;
  const std::uint64_t max_pixels_;
  ComputeSlots slots_;
  std::atomic<bool> streams_end_ = false;
};

}  // namespace fovea::server
