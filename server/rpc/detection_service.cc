#include "server/rpc/detection_service.h"

#include <utility>

#include "server/status.h"
#include "server/watching/statistics.h"

namespace fovea::server {
namespace {

constexpr int kDetect = 0;  // its place in the contract

}  // namespace

DetectionService::DetectionService(v1::GetServerInfoResponse info, v1::ListOptionsResponse options,
                                   const Metrics& metrics, const GateKeeper& gate_keeper,
                                   ConnectionTable& connections)
    : info_(std::move(info)),
      options_(std::move(options)),
      metrics_(metrics),
      gate_keeper_(gate_keeper),
      connections_(connections) {
  // What gRPC has for its "streamed unary" methods: the same on the wire.
  MarkMethodStreamed(kDetect, nullptr);
  MarkMethodAsync(kDetect);
}

void DetectionService::RequestDetect(
    grpc::ServerContext* context,
    grpc::ServerAsyncReader<v1::DetectResponse, grpc::ByteBuffer>* reader,
    grpc::ServerCompletionQueue* queue, void* tag) {
  RequestAsyncClientStreaming(kDetect, context, reader, queue, queue, tag);
}

grpc::Status DetectionService::GetServerInfo(grpc::ServerContext* context,
                                             const v1::GetServerInfoRequest* /*request*/,
                                             v1::GetServerInfoResponse* response) {
  return IfAdmitted(*context, [&] { *response = info_; });
}

grpc::Status DetectionService::GetStatistics(grpc::ServerContext* context,
                                             const v1::GetStatisticsRequest* /*request*/,
                                             v1::GetStatisticsResponse* response) {
  return IfAdmitted(*context, [&] {
    *response = StatisticsOf(metrics_.Collect(), std::chrono::steady_clock::now() - started_);
  });
}

grpc::Status DetectionService::ListOptions(grpc::ServerContext* context,
                                           const v1::ListOptionsRequest* /*request*/,
                                           v1::ListOptionsResponse* response) {
  return IfAdmitted(*context, [&] { *response = options_; });
}

grpc::Status DetectionService::IfAdmitted(const grpc::ServerContext& context,
                                          const std::function<void()>& answer) const {
  try {
    gate_keeper_.Admit(context);
    connections_.Admit(context.peer());
    answer();
    return grpc::Status::OK;
  } catch (...) {
    return StatusOfCurrentException(/*deadline_passed=*/false);
  }
}

}  // namespace fovea::server
