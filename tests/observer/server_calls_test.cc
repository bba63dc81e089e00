#include "client/observer/server_calls.h"

#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include <future>
#include <stop_token>
#include <string>
#include <thread>

#include "fovea/v1/observation_service.grpc.pb.h"

namespace fovea::testing {
namespace {

// Answers nobody, as where robots leave no processor free.
class BusyService final : public v1::ObservationService::Service {
 public:
  std::promise<void> began;

 private:
  grpc::Status Try(grpc::ServerContext* context, const v1::TryRequest*, v1::TryResponse*) override {
    began.set_value();
    while (!context->IsCancelled()) std::this_thread::yield();
    return grpc::Status::CANCELLED;
  }
};

TEST(ObserverServerCalls, EndWhenTheyAreToldTo) {
  BusyService service;
  int port = 0;
  const auto server = grpc::ServerBuilder()
                          .AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port)
                          .RegisterService(&service)
                          .BuildAndStart();
  const auto link = observer::LinkServers("127.0.0.1:" + std::to_string(port), {}).front();
  std::stop_source stop;
  v1::TryResponse response;
  const auto ask = [&] { return observer::Try(link, "token", {}, &response, stop.get_token()); };
  auto status = std::async(std::launch::async, ask);
  service.began.get_future().wait();
  stop.request_stop();
  EXPECT_EQ(status.get().error_code(), grpc::StatusCode::CANCELLED);
  EXPECT_EQ(ask().error_code(), grpc::StatusCode::CANCELLED) << "one that begins later";
}

}  // namespace
}  // namespace fovea::testing
