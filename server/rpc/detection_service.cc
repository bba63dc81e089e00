#include "server/rpc/detection_service.h"

#include <utility>

#include "server/connections/call_account.h"
#include "server/rpc/call_names.h"
#include "server/rpc/late_reading.h"
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
  constexpr int kGetServerInfo = 2, kGetStatistics = 3, kListOptions = 4;
  Answer<v1::GetServerInfoResponse>(kGetServerInfo, [this] { return info_; });
  Answer<v1::ListOptionsResponse>(kListOptions, [this] { return options_; });
  Answer<v1::GetStatisticsResponse>(kGetStatistics, [this] {
    return StatisticsOf(metrics_.Collect(), std::chrono::steady_clock::now() - started_);
  });
}

void DetectionService::RequestDetect(
    grpc::ServerContext* context,
    grpc::ServerAsyncReader<v1::DetectResponse, grpc::ByteBuffer>* reader,
    grpc::ServerCompletionQueue* queue, void* tag) {
  RequestAsyncClientStreaming(kDetect, context, reader, queue, queue, tag);
}

template <typename Response>
void DetectionService::Answer(int method, std::function<Response()> answer) {
  const auto if_admitted = [this, answer = std::move(answer)](grpc::ServerContext* context,
                                                              LateStream<Response>* /*stream*/,
                                                              Response* response) {
    context->AddTrailingMetadata(kRequestIdKey, RequestId(context->client_metadata()));
    gate_keeper_.Admit(*context);
    CallAccount account(connections_);
    account.Admit(context->peer());
    *response = answer();
    return grpc::Status::OK;
  };
  MarkMethodStreamed(method, LateReading<Response>(if_admitted, [this] { return *rules_; }));
}

}  // namespace fovea::server
