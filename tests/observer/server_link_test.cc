// Which servers are asked, and what of them is taken.
#include "client/observer/server_link.h"

#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include <future>
#include <mutex>
#include <string>

#include "client/observer/watch_stream.h"
#include "fovea/v1/observation_service.grpc.pb.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using client::ServerTarget;
using observer::TargetOf;

constexpr std::size_t kLarge = std::size_t{80} << 20;

ServerTarget TargetOfText(const std::string& text) {
  return TargetOf(client::ParseServerAddresses(text).front());
}

// A frame, an answer with clouds and what both look like.
class LargeFrames final : public v1::ObservationService::Service {
  grpc::Status Watch(grpc::ServerContext*, const v1::WatchRequest*,
                     grpc::ServerWriter<v1::WatchResponse>* writer) override {
    v1::WatchResponse response;
    response.mutable_frame()->set_picture(std::string(kLarge, 'x'));
    writer->Write(response);
    return grpc::Status::OK;
  }
};

TEST(ObserverServerLink, LeavesNamesToGrpcWhichLooksThemUpAgain) {
  EXPECT_EQ(TargetOfText("localhost:7"), (ServerTarget{"dns:///localhost:7", "localhost:7"}));
  EXPECT_EQ(TargetOfText("no.such.example:7").target, "dns:///no.such.example:7");
  EXPECT_EQ(TargetOfText("127.0.0.1:7").target, "ipv4:127.0.0.1:7");
  EXPECT_EQ(TargetOfText("[::1]:7").target, "ipv6:[::1]:7");
  EXPECT_EQ(TargetOfText("unix:/run/fovea").target, "unix:/run/fovea");
}

TEST(ObserverServerLink, TakesMessagesThatAreLargerThanAnswers) {
  LargeFrames service;
  int port = 0;
  const auto server = grpc::ServerBuilder()
                          .AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port)
                          .RegisterService(&service)
                          .BuildAndStart();
  std::promise<std::size_t> size;
  std::once_flag first;
  const auto link = observer::LinkServers("127.0.0.1:" + std::to_string(port), {}).front();
  const observer::WatchStream stream(
      link, "token", {},
      {.on_observer = [](const v1::Observer&) {},
       .on_frame =
           [&](v1::WatchResponse response) {
             std::call_once(first, [&] { size.set_value(response.frame().picture().size()); });
           },
       .on_state = [](const observer::LinkState&) {}});
  auto came = size.get_future();
  ASSERT_EQ(came.wait_for(kPatience), std::future_status::ready);
  EXPECT_EQ(came.get(), kLarge);
}

}  // namespace
}  // namespace fovea::testing
