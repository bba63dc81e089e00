// Messages are read once their caller has been let in, and no larger than they need to be.
#include <gmock/gmock.h>

#include "tests/server/detectors.h"
#include "tests/server/metric_value.h"
#include "tests/server/observers.h"
#include "tests/server/raw_call.h"

namespace fovea::testing {
namespace {

using ::testing::EndsWith;

constexpr const char* kBroken = "\xFF\xFF";

class LateReading : public Observers {
 protected:
  LateReading() {
    options_.tokens =
        folder_.Write("tokens", "kitchen " + server::HashOfToken("robots-token") + "\n");
  }

  grpc::Status Call(const std::string& method, const std::string& message,
                    const std::string& token) {
    return RawCall(loopback().server.Address(), "/fovea.v1." + method, message, token);
  }
  const Loopback& loopback() {
    if (!loopback_) loopback_ = std::make_unique<Loopback>(FindOne, options_);
    return *loopback_;
  }

 private:
  std::unique_ptr<Loopback> loopback_;
};

TEST_F(LateReading, ComesAfterTheTokenWasLookedAt) {
  for (const std::string method :
       {"DetectionService/Detect", "DetectionService/GetServerInfo",
        "DetectionService/GetStatistics", "DetectionService/ListOptions", "ObservationService/Try",
        "ObservationService/ListOptions", "ObservationService/SelectObject"}) {
    for (const std::string token : {"", "nobodys"}) {
      EXPECT_EQ(Call(method, kBroken, token).error_code(), grpc::StatusCode::UNAUTHENTICATED)
          << method;
    }
  }
}

TEST_F(LateReading, IsLeftOutWhereMessagesSayNothing) {
  for (const std::string method : {"GetServerInfo", "GetStatistics", "ListOptions"}) {
    const std::string megabytes(std::size_t{4} << 20, '\x7B');
    EXPECT_TRUE(Call("DetectionService/" + method, megabytes, "robots-token").ok()) << method;
  }
  EXPECT_TRUE(Call("ObservationService/ListOptions", kBroken, "all-of-it").ok());
}

TEST_F(LateReading, TellsWhatIsNoMessage) {
  for (const std::string name : {"Try", "SelectObject"}) {
    const grpc::Status status = Call("ObservationService/" + name, kBroken, "all-of-it");
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_EQ(status.error_message(), "the message is not a " + name + "Request");
  }
}

// Beside a stream that says nothing, to which their bytes could belong as well.
TEST_F(LateReading, OwesNothingOfWhatWasRead) {
  constexpr int kMoreThanAConnectionMayOwe = 100;
  const auto channel =
      grpc::CreateChannel(loopback().server.Address(), grpc::InsecureChannelCredentials());
  grpc::ClientContext context;
  context.AddMetadata("authorization", "Bearer robots-token");
  const auto stream = v1::DetectionService::NewStub(channel)->DetectStream(&context);
  v1::DetectStreamResponse opened;
  ASSERT_TRUE(stream->Write({}) && stream->Read(&opened));
  const std::string megabyte(std::size_t{1} << 20, '\xFF');
  for (const std::string name : {"Try", "SelectObject"}) {
    for (int i = 0; i < kMoreThanAConnectionMayOwe; ++i) {
      ASSERT_EQ(Call("ObservationService/" + name, megabyte, "all-of-it").error_code(),
                grpc::StatusCode::INVALID_ARGUMENT);
    }
  }
  EXPECT_EQ(MetricValue(*loopback().server.metrics(), "fovea_connections"), 1)
      << "all of these went by that of the stream";
  context.TryCancel();
}

// Each of these takes a hundred times its bytes, once it is parsed.
TEST_F(LateReading, RefusesWhatWouldTakeMuchMemory) {
  v1::DetectRequest request = TestRequest();
  for (int i = 0; i < 40'000; ++i) request.mutable_options()->mutable_grasps()->add_grippers();
  std::string groups;
  for (int i = 0; i < 40'000; ++i) groups += "\x7B\x7C";
  for (const std::string& message : {request.SerializeAsString(), groups}) {
    const grpc::Status status = Call("DetectionService/Detect", message, "robots-token");
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_THAT(status.error_message(), EndsWith("has more than 65536 bytes beside its images"));
  }
}

}  // namespace
}  // namespace fovea::testing
