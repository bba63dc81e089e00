#include "client/better_server.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "client/client.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"

namespace fovea::client {
namespace {

using testing::kPatience;

server::ServerOptions OneThread() {
  server::ServerOptions options = testing::LoopbackOptions();
  options.compute_threads = 1;
  return options;
}

TEST(BetterServer, IsOneThatHasNothingToDoWhereFramesWaitAtTheOwn) {
  testing::Gate gate;
  testing::Loopback busy(std::ref(gate), OneThread());
  const testing::Loopback idle(testing::FindOne, OneThread());
  const ClientOptions options{.timeout = kPatience};
  Servers servers(busy.server.Address() + "," + idle.server.Address(), options);
  std::string problem;
  const auto all = servers.All(Servers::Clock::now() + kPatience, &problem);
  const auto own = *std::ranges::find(all, "ipv4:" + busy.server.Address(), &Server::name);
  BetterServer better(servers, options, std::chrono::milliseconds(0), kPatience);
  EXPECT_FALSE(better.Find(own));  // nothing waits

  v1::DetectStreamRequest request;
  *request.mutable_frame() = testing::TestFrame();
  std::vector<std::unique_ptr<DetectStream>> streams;
  for (int i = 0; i < 3; ++i) {
    streams.push_back(busy.client.OpenStream(kPatience));
    streams.back()->Send(request);
  }
  gate.WaitUntilBegun();
  testing::AwaitMetric(*busy.server.metrics(), "fovea_frames_waiting", 2);
  EXPECT_FALSE(better.Find(own));  // it is not known yet how fast that is
  gate.Let();
  gate.WaitUntilBegun();
  testing::AwaitMetric(*busy.server.metrics(), "fovea_frames_answered_total", 1);
  const auto found = better.Find(own);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->name, "ipv4:" + idle.server.Address());
  gate.Let(2);
}

}  // namespace
}  // namespace fovea::client
