#include "tests/load/robot.h"

#include <gmock/gmock.h>
#include <grpcpp/ext/health_check_service_server_builder_option.h>
#include <grpcpp/grpcpp.h>

#include <chrono>
#include <cstdint>
#include <memory>

#include "client/client.h"
#include "fovea/v1/detection_service.grpc.pb.h"

namespace fovea::load {
namespace {

using testing::ElementsAre;
using testing::Gt;
using testing::Pair;

// Answers calls with the time that its processor was not there, the last frame of streams with an
// error, and has the robots stop, those of streams once their frames are noted.
class OneAnswer final : public v1::DetectionService::Service {
 public:
  OneAnswer() {
    grpc::EnableDefaultHealthCheckService(true);
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port_);
    builder.RegisterService(this);
    server_ = builder.BuildAndStart();
    server_->GetHealthCheckService()->SetServingStatus("fovea.v1.DetectionService", true);
  }
  ~OneAnswer() override { server_->Shutdown(); }

  Outcome Run(bool stream, std::chrono::milliseconds warm_up = {}) {
    RobotPlan plan;
    plan.rate_hz = kRate_hz;
    plan.noted_from = std::chrono::steady_clock::now() + warm_up;
    most_of_warm_up_ =
        static_cast<std::uint64_t>(std::chrono::duration<double>(warm_up).count() * kRate_hz) + 1;
    plan.servers = {"127.0.0.1:" + std::to_string(port_)};
    plan.stream = stream;
    return RunRobot(plan, stop_.get_token());
  }

 private:
  static constexpr double kRate_hz = 30;

  grpc::Status Detect(grpc::ServerContext* /*context*/, const v1::DetectRequest* /*request*/,
                      v1::DetectResponse* response) override {
    v1::StageTime& wait = *response->mutable_detections()->add_stage_times();
    wait.set_stage("processor_wait");
    wait.mutable_duration()->set_seconds(3600);
    stop_.request_stop();
    return grpc::Status::OK;
  }

  using Frames = grpc::ServerReaderWriter<v1::DetectStreamResponse, v1::DetectStreamRequest>;
  grpc::Status DetectStream(grpc::ServerContext* /*context*/, Frames* frames) override {
    v1::DetectStreamRequest request;
    v1::DetectStreamResponse response;
    std::uint64_t num_read = 0;
    for (; frames->Read(&request); ++num_read) {
      if (num_read > most_of_warm_up_) stop_.request_stop();
    }
    response.set_sequence(num_read - 1);
    response.set_dropped(num_read - 1);
    response.mutable_error()->set_code(grpc::StatusCode::INVALID_ARGUMENT);
    frames->Write(response);
    return grpc::Status::OK;
  }

  int port_ = 0;
  // Frames that can have been sent before those that are noted, at that rate. When they are read
  // says nothing of when they were sent.
  std::uint64_t most_of_warm_up_ = 0;
  std::stop_source stop_;
  std::unique_ptr<grpc::Server> server_;
};

TEST(Robot, CountsTheWaitForAProcessorOnce) {
  const Outcome outcome = OneAnswer().Run(/*stream=*/false);
  EXPECT_THAT(outcome.overhead_ms, ElementsAre(Gt(0)));
}

TEST(Robot, NamesTheErrorsOfStreams) {
  const Outcome outcome = OneAnswer().Run(/*stream=*/true);
  EXPECT_THAT(outcome.errors, ElementsAre(Pair("INVALID_ARGUMENT", 1)));
}

TEST(Robot, NotesNoneThatWereDroppedOfTheWarmUp) {
  const Outcome outcome = OneAnswer().Run(/*stream=*/true, std::chrono::milliseconds(500));
  EXPECT_EQ(outcome.dropped + outcome.errors.at("INVALID_ARGUMENT"), outcome.sent);
}

TEST(Robot, IsNotStartedWithoutItsServer) {
  RobotPlan plan;
  plan.servers = {"no address"};
  EXPECT_THROW(WaitForServers({plan}), std::invalid_argument);
}

}  // namespace
}  // namespace fovea::load
