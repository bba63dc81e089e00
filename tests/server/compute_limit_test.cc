// A frame that takes too long is given up in the midst of a stage, and says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/interruption.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;

// One stage without an end.
Detections ComputeForEver(const RgbdFrame& /*frame*/, const DetectorOptions& /*options*/,
                          Trace* /*trace*/, const std::function<bool()>& should_stop) {
  InterruptionScope scope(should_stop);
  scope.Enter("graph_cut");
  while (true) InterruptionPoint();
}

server::ServerOptions WithLimit(int max_compute_ms) {
  server::ServerOptions options = LoopbackOptions();
  options.max_compute_ms = max_compute_ms;
  return options;
}

TEST(ComputeLimit, EndsAFrameThatTakesMore) {
  Loopback loopback(ComputeForEver, WithLimit(20));
  try {
    loopback.client.Detect(TestRequest());
    FAIL() << "was answered";
  } catch (const client::RpcError& error) {
    EXPECT_EQ(error.code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
    EXPECT_THAT(error.message(), HasSubstr("more than 20 ms of computing"));
    EXPECT_THAT(error.message(), HasSubstr("stage graph_cut"));
    EXPECT_FALSE(error.retry_after()) << "it would take as long again";
  }
}

TEST(ComputeLimit, IsNotThatOfTheCaller) {
  Loopback loopback(ComputeForEver, WithLimit(0));
  const grpc::Status status =
      StatusOf([&] { loopback.client.Detect(TestRequest(), std::chrono::milliseconds(100)); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
}

}  // namespace
}  // namespace fovea::testing
