// A frame that takes too long is given up in the midst of a stage, and says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/cancelled.h"
#include "core/types/interruption.h"
#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"

namespace fovea::testing {
namespace {

using ::testing::ContainsRegex;
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

// The second stage has no end.
Detections StayInTheGraphCut(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                             const std::function<bool()>& should_stop) try {
  return ComputeForEver(frame, options, trace, should_stop);
} catch (Cancelled& cancelled) {
  cancelled.stage_times = {{"depth", 2.0}, {"graph_cut", 30.0}};
  throw;
}

TEST(ComputeLimit, LeavesTheTimesOfStagesInTheLog) {
  const CapturedLog log;
  server::ServerOptions options = WithLimit(5);
  options.slow_ms = 1;
  {
    const Loopback loopback(StayInTheGraphCut, options);
    EXPECT_EQ(StatusOf([&] { loopback.client.Detect(TestRequest()); }).error_code(),
              grpc::StatusCode::RESOURCE_EXHAUSTED);
    EXPECT_EQ(MetricValue(*loopback.server.metrics(), "fovea_stage_seconds"), 0)
        << "counts frames that were answered";
  }
  EXPECT_THAT(log.text(), ContainsRegex("slow request=.* code=RESOURCE_EXHAUSTED .* queue_ms=.* "
                                        "decode_ms=.* depth_ms=2.0 graph_cut_ms=30.0"));
}

TEST(ComputeLimit, IsNotThatOfTheCaller) {
  Loopback loopback(ComputeForEver, WithLimit(0));
  const grpc::Status status =
      StatusOf([&] { loopback.client.Detect(TestRequest(), std::chrono::milliseconds(100)); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
}

}  // namespace
}  // namespace fovea::testing
