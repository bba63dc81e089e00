#include "client/client.h"

#include <utility>

#include "client/channel.h"
#include "client/retry.h"
#include "grpc/health/v1/health.grpc.pb.h"

namespace fovea::client {
namespace {

namespace health = grpc::health::v1;

health::HealthCheckRequest AboutDetection() {
  health::HealthCheckRequest request;
  request.set_service(v1::DetectionService::service_full_name());
  return request;
}

}  // namespace

Client::Client(const std::string& address, ClientOptions options)
    : options_(std::move(options)),
      channel_(MakeChannel(address, options_)),
      stub_(v1::DetectionService::NewStub(channel_)) {}

void Client::WaitUntilReady(std::chrono::milliseconds timeout) const {
  grpc::ClientContext context;
  PrepareCall(options_, timeout, &context);
  context.set_wait_for_ready(true);  // a server that is not up yet is no error
  const auto watch = health::Health::NewStub(channel_)->Watch(&context, AboutDetection());
  health::HealthCheckResponse response;
  while (watch->Read(&response)) {
    if (response.status() != health::HealthCheckResponse::SERVING) continue;
    context.TryCancel();
    watch->Finish();
    return;
  }
  const grpc::Status status = watch->Finish();
  throw RpcError({status.ok() ? grpc::StatusCode::UNAVAILABLE : status.error_code(),
                  "the server is not ready: " + status.error_message()});
}

bool Client::IsServing() const {
  grpc::ClientContext context;
  PrepareCall(options_, options_.timeout, &context);
  health::HealthCheckResponse response;
  const grpc::Status status =
      health::Health::NewStub(channel_)->Check(&context, AboutDetection(), &response);
  if (!status.ok()) throw RpcError(status);
  return response.status() == health::HealthCheckResponse::SERVING;
}

v1::GetServerInfoResponse Client::GetServerInfo() const {
  v1::GetServerInfoResponse response;
  CallWithRetries(*channel_, options_, options_.timeout, [&](grpc::ClientContext* context) {
    return stub_->GetServerInfo(context, {}, &response);
  });
  return response;
}

v1::GetStatisticsResponse Client::GetStatistics() const {
  v1::GetStatisticsResponse response;
  CallWithRetries(*channel_, options_, options_.timeout, [&](grpc::ClientContext* context) {
    return stub_->GetStatistics(context, {}, &response);
  });
  return response;
}

v1::ListOptionsResponse Client::ListOptions() const {
  v1::ListOptionsResponse response;
  CallWithRetries(*channel_, options_, options_.timeout, [&](grpc::ClientContext* context) {
    return stub_->ListOptions(context, {}, &response);
  });
  return response;
}

v1::DetectResponse Client::Detect(const v1::DetectRequest& request) const {
  return Detect(request, options_.timeout);
}

v1::DetectResponse Client::Detect(const v1::DetectRequest& request,
                                  std::chrono::milliseconds timeout) const {
  v1::DetectResponse response;
  CallWithRetries(*channel_, options_, timeout, [&](grpc::ClientContext* context) {
    return stub_->Detect(context, request, &response);
  });
  return response;
}

std::unique_ptr<DetectStream> Client::OpenStream(std::chrono::milliseconds timeout) const {
  return std::make_unique<DetectStream>(*stub_, options_, timeout);
}

std::unique_ptr<ResumingStream> Client::OpenResumingStream(
    std::chrono::milliseconds timeout) const {
  return std::make_unique<ResumingStream>(channel_, stub_, options_, timeout);
}

}  // namespace fovea::client
