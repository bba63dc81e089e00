// Servers that keep whoever wants an answer to every frame waiting.
#include <gmock/gmock.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>

#include "fovea/v1/detection_service.grpc.pb.h"
#include "tests/capture/capture_process.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Has no room for the second frame until it came so many times.
class BusyService : public v1::DetectionService::Service {
 public:
  BusyService(int num_refusals, std::string retry_after_ms)
      : num_refusals_(num_refusals), retry_after_ms_(std::move(retry_after_ms)) {}

  grpc::Status Detect(grpc::ServerContext* context, const v1::DetectRequest*,
                      v1::DetectResponse* response) override {
    const int call = num_calls_++;
    if (call == 0 || call > num_refusals_) {
      response->mutable_detections();
      return grpc::Status::OK;
    }
    context->AddTrailingMetadata("retry-after-ms", retry_after_ms_);
    return {grpc::StatusCode::RESOURCE_EXHAUSTED, "no room"};
  }

 private:
  const int num_refusals_;
  const std::string retry_after_ms_;
  std::atomic<int> num_calls_ = 0;
};

// Answers nothing until the caller gives up.
struct HangingService : v1::DetectionService::Service {
  std::promise<void> called;

  grpc::Status Detect(grpc::ServerContext* context, const v1::DetectRequest*,
                      v1::DetectResponse*) override {
    called.set_value();
    while (!context->IsCancelled()) std::this_thread::yield();
    return grpc::Status::CANCELLED;
  }
};

class EveryFrameTest : public CaptureTest {
 protected:
  Finished CaptureFrom(BusyService& service, std::vector<std::string> flags) const {
    int port = 0;
    const auto server =
        grpc::ServerBuilder()
            .AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port)
            .RegisterService(&service)
            .BuildAndStart();
    flags.insert(flags.end(), {"--any-version", "--server", "127.0.0.1:" + std::to_string(port)});
    return Capture(flags);
  }
};

TEST_F(EveryFrameTest, WaitsForRoomForLongerThanACall) {
  BusyService service(/*num_refusals=*/7, "1");
  const Finished finished =
      CaptureFrom(service, {"--resolution", "320x240", "--every-frame", "--frames", "3"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(CountOf(finished.out, "answered"), 3) << finished.out;
  EXPECT_EQ(CountOf(finished.out, "failed;"), 0) << finished.out;
}

// The call has a minute.
TEST_F(EveryFrameTest, EndsOnSignalsWhereItsServerHangs) {
  HangingService service;
  int port = 0;
  const auto server = grpc::ServerBuilder()
                          .AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port)
                          .RegisterService(&service)
                          .BuildAndStart();
  std::vector<std::string> command =
      CommandLine({"--resolution", "320x240", "--every-frame", "--any-version", "--server",
                   "127.0.0.1:" + std::to_string(port)});
  const auto limit = std::ranges::find(command, "timeout");
  command.erase(limit, limit + 3);  // it would kill what goes on for 5 s after a signal
  Process capture(command);
  service.called.get_future().wait();
  capture.Signal(SIGINT);
  const Finished finished = capture.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("the last answer did not come in time\n"));
  EXPECT_EQ(CountOf(finished.out, "lost\n"), 1) << finished.out;
}

TEST_F(EveryFrameTest, TheWaitForAnAnswerIsNoSilenceOfTheCamera) {
  // The camera's frames must come within a time that a machine with other work has, too.
  BusyService busy_live(/*num_refusals=*/1, "2000");
  const Finished live = CaptureFrom(busy_live, {"--resolution", "320x240", "--every-frame",
                                                "--frames", "3", "--frame-timeout", "1.5"});
  EXPECT_THAT(live.err, Not(HasSubstr("no frames arrive"))) << live.out;

  ASSERT_EQ(Capture(Record(At("a.oni"), {"--frames", "7"})).exit_code, 0);
  BusyService busy_replay(/*num_refusals=*/1, "2000");
  const Finished replay =
      CaptureFrom(busy_replay, {"replay", At("a.oni"), "--frame-timeout", "1.5"});
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_THAT(replay.out, HasSubstr("end of the recording\n"));
  EXPECT_GE(CountOf(replay.out, "answered"), 7) << replay.out;
}

}  // namespace
}  // namespace fovea::testing
