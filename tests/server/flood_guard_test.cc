// Calls as gRPC itself counts them, and who does not begin too many. tests/attacks has those who
// do.
#include "server/connections/flood_guard.h"

#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>

#include "grpc/health/v1/health.grpc.pb.h"
#include "server/connections/begun_calls.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

namespace health = grpc::health::v1;

// Calls that the server does not let in.
void AskForHealth(const std::shared_ptr<grpc::Channel>& channel) {
  grpc::ClientContext context;
  context.set_wait_for_ready(true);
  context.set_deadline(std::chrono::system_clock::now() + kPatience);
  health::HealthCheckResponse response;
  EXPECT_TRUE(health::Health::NewStub(channel)->Check(&context, {}, &response).ok());
}

TEST(BegunCalls, AreCountedInAllAndByConnection) {
  const Loopback loopback(FindOne);
  const std::uint64_t before = server::NumBegunCalls();
  for (int i = 0; i < 3; ++i) loopback.client.Detect(TestRequest());
  EXPECT_EQ(server::NumBegunCalls() - before, 3U);
  const auto calls = server::BegunCallsByConnection();
  ASSERT_EQ(calls.size(), 1U);
  EXPECT_THAT(calls.front().peer, ::testing::MatchesRegex("ipv4:127\\.0\\.0\\.1:[1-9][0-9]*"));
  EXPECT_EQ(calls.front().begun, 3U);
}

TEST(FloodGuard, LeavesARobotThatAsksForItsHealthNowAndThen) {
  const Loopback loopback(FindOne);
  loopback.client.Detect(TestRequest());
  const auto channel =
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials());
  for (int i = 0; i < 30; ++i) AskForHealth(channel);
  loopback.client.Detect(TestRequest());
  EXPECT_EQ(loopback.server.connections().counts().ended, 0U);
}

}  // namespace
}  // namespace fovea::testing
