#include "client/observer/server_calls.h"

#include <grpcpp/client_context.h>

#include <chrono>

#include "fovea/v1/observation_service.grpc.pb.h"

namespace fovea::observer {
namespace {

// A frame that is tried waits until robots leave a processor free.
constexpr std::chrono::seconds kTryTime{60}, kCallTime{10};

template <typename Call>
grpc::Status Ask(const ServerLink& server, const std::string& token, std::chrono::seconds time,
                 const std::stop_token& stop, Call call) {
  const auto stub = v1::ObservationService::NewStub(server.channel);
  grpc::ClientContext context;
  context.AddMetadata("authorization", "Bearer " + token);
  context.set_deadline(std::chrono::system_clock::now() + time);
  const std::stop_callback cancel(stop, [&] { context.TryCancel(); });
  return call(*stub, &context);
}

}  // namespace

grpc::Status Try(const ServerLink& server, const std::string& token, const v1::TryRequest& request,
                 v1::TryResponse* response, const std::stop_token& stop) {
  return Ask(server, token, kTryTime, stop, [&](auto& stub, grpc::ClientContext* context) {
    return stub.Try(context, request, response);
  });
}

grpc::Status ListOptions(const ServerLink& server, const std::string& token,
                         v1::ListOptionsResponse* response, const std::stop_token& stop) {
  return Ask(server, token, kCallTime, stop, [&](auto& stub, grpc::ClientContext* context) {
    return stub.ListOptions(context, {}, response);
  });
}

grpc::Status SelectObject(const ServerLink& server, const std::string& token,
                          const v1::SelectObjectRequest& request,
                          v1::SelectObjectResponse* response, const std::stop_token& stop) {
  return Ask(server, token, kCallTime, stop, [&](auto& stub, grpc::ClientContext* context) {
    return stub.SelectObject(context, request, response);
  });
}

}  // namespace fovea::observer
