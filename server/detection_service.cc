#include "server/detection_service.h"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "server/conversion/detections.h"
#include "server/conversion/field_error.h"
#include "server/conversion/frame.h"
#include "server/conversion/options.h"
#include "server/request_log.h"
#include "server/status.h"

namespace fovea::server {
namespace {

bool DeadlinePassed(const grpc::ServerContext& context) {
  return std::chrono::system_clock::now() >= context.deadline();
}

template <typename Request>
const v1::Frame* FrameOf(const Request& request) {
  return request.has_frame() ? &request.frame() : nullptr;
}

// A stream answers a bad frame and goes on; it ends with a caller that is gone or out of time.
bool EndsStream(grpc::StatusCode code) {
  return code == grpc::StatusCode::CANCELLED || code == grpc::StatusCode::DEADLINE_EXCEEDED;
}

void SetError(const grpc::Status& status, v1::DetectStreamResponse* response) {
  response->mutable_error()->set_code(status.error_code());
  response->mutable_error()->set_message(status.error_message());
}

}  // namespace

DetectionService::DetectionService(DetectFunction detect, std::int64_t max_pixels,
                                   int max_concurrent)
    : detect_(std::move(detect)),
      max_pixels_(static_cast<std::uint64_t>(max_pixels)),
      slots_(max_concurrent) {}

grpc::Status DetectionService::Detect(grpc::ServerContext* context,
                                      const v1::DetectRequest* request,
                                      v1::DetectResponse* response) {
  return Answer(*context, FrameOf(*request), request->options(), response->mutable_detections());
}

grpc::Status DetectionService::DetectStream(grpc::ServerContext* context, Stream* stream) {
  v1::DetectStreamRequest request;
  v1::DetectOptions options;
  for (std::uint64_t sequence = 0; stream->Read(&request); ++sequence) {
    if (request.has_options()) options = request.options();
    v1::DetectStreamResponse response;
    response.set_frame_id(request.frame().id());
    response.set_sequence(sequence);
    grpc::Status status =
        Answer(*context, FrameOf(request), options, response.mutable_detections());
    if (EndsStream(status.error_code())) return status;
    if (!status.ok()) SetError(status, &response);
    if (!stream->Write(response)) break;
    if (streams_end_) return {grpc::StatusCode::UNAVAILABLE, "the server is stopping"};
  }
  return grpc::Status::OK;
}

grpc::Status DetectionService::Answer(const grpc::ServerContext& context, const v1::Frame* frame,
                                      const v1::DetectOptions& options,
                                      v1::Detections* detections) {
  const auto start = std::chrono::steady_clock::now();
  grpc::Status status;
  try {
    RequireField(frame != nullptr, "frame", "is missing");
    *detections = Compute(context, *frame, options);
  } catch (...) {
    status = StatusOfCurrentException(DeadlinePassed(context));
  }
  LogFrame(frame != nullptr ? frame->id() : "", status,
           static_cast<std::size_t>(detections->objects_size()),
           std::chrono::steady_clock::now() - start);
  return status;
}

v1::Detections DetectionService::Compute(const grpc::ServerContext& context, const v1::Frame& frame,
                                         const v1::DetectOptions& options) {
  const auto should_stop = [&] { return context.IsCancelled() || DeadlinePassed(context); };
  const DetectorOptions detector_options = FromProto(options);
  const ComputeSlots::Slot slot = slots_.Acquire(should_stop);

  const auto start = std::chrono::steady_clock::now();
  const RgbdFrame decoded = FromProto(frame, max_pixels_);
  const std::chrono::duration<double, std::milli> decode_time =
      std::chrono::steady_clock::now() - start;

  Trace trace;
  Detections detections;
  try {
    detections =
        detect_(decoded, detector_options, WantsTrace(options) ? &trace : nullptr, should_stop);
  } catch (const std::invalid_argument& error) {
    // Options were validated before: what the core still finds is about the frame.
    throw std::invalid_argument("frame." + std::string(error.what()));
  }
  detections.stage_times.insert(detections.stage_times.begin(), {"decode", decode_time.count()});
  return ToProto(detections, trace, frame, options);
}

}  // namespace fovea::server
