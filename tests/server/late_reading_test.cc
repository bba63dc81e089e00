// Messages are read once their caller has been let in, and no larger than they need to be.
#include <gmock/gmock.h>

#include "tests/server/detectors.h"
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
