// Tokens that change while the server serves.
#include <grpcpp/create_channel.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>

#include "server/access/certificates.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {
namespace {

using client::Client;
using client::ClientOptions;

class TokenChanges : public ::testing::Test {
 protected:
  static constexpr const char* kHash =
      "a3ee786b5707c27d42570785081ec17f5c7db9262a01366af362a1aa61a420b9";  // of let-me-in
  static constexpr const char* kOther =
      "d9298a10d1b0735837dc4bd85dac641b0f3cef27a47e5d53a54f2f3f5b2fcffa";

  TokenChanges() { WriteTokens(std::string("kitchen ") + kHash); }

  void WriteTokens(const std::string& text) { options_.tokens = folder_.Write("tokens", text); }
  static Client Kitchen(const Loopback& loopback) {
    ClientOptions options = PatientOptions();
    options.token = "let-me-in";
    return Client(loopback.server.Address(), options);
  }
  static void ExpectEnd(client::DetectStream& stream, const std::string& why) {
    const grpc::Status status = StatusOf([&] { stream.Receive(); });
    EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAUTHENTICATED);
    EXPECT_EQ(status.error_message(), why);
  }

  const TemporaryFolder folder_;
  server::ServerOptions options_ = LoopbackOptions();
};

TEST_F(TokenChanges, AreTakenOverWhenReloaded) {
  Loopback loopback(FindOne, options_);
  const Client client = Kitchen(loopback);
  const auto detect = [&] { client.Detect(TestRequest()); };
  WriteTokens("nonsense");
  EXPECT_THROW(loopback.server.ReloadAccess(), std::invalid_argument);
  EXPECT_NO_THROW(detect());
  WriteTokens(std::string("hall ") + kOther);
  loopback.server.ReloadAccess();
  EXPECT_EQ(StatusOf(detect).error_code(), grpc::StatusCode::UNAUTHENTICATED);
}

TEST_F(TokenChanges, ARemovedTokenEndsItsStreams) {
  Loopback loopback(FindOne, options_);
  const Client client = Kitchen(loopback);
  const auto stream = AnsweredStream(client);
  loopback.server.ReloadAccess();  // nothing has changed
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  EXPECT_TRUE(stream->Send(request));
  EXPECT_TRUE(stream->Receive());
  WriteTokens(std::string("hall ") + kOther);
  loopback.server.ReloadAccess();
  ExpectEnd(*stream, "the token is not known");
}

TEST_F(TokenChanges, ATokenThatBecomesAnothersEndsItsStreams) {
  Loopback loopback(FindOne, options_);
  const Client client = Kitchen(loopback);
  const auto stream = AnsweredStream(client);
  WriteTokens(std::string("hall ") + kHash);
  loopback.server.ReloadAccess();
  ExpectEnd(*stream, "the token is another robot's now");
}

TEST_F(TokenChanges, AnIdleStreamEndsWhenItsTokenExpires) {
  // In whole seconds: long enough to open the stream, or the test says that it was not.
  const auto soon = std::chrono::ceil<std::chrono::seconds>(std::chrono::system_clock::now()) +
                    std::chrono::seconds(3);
  WriteTokens(std::string("kitchen ") + kHash + " " + server::TextOf(soon));
  const Loopback loopback(FindOne, options_);
  const Client client = Kitchen(loopback);
  const auto stream = AnsweredStream(client);
  ExpectEnd(*stream, "the token has expired");
}

// The answer that is computed is sent; the frame that waits gets none.
TEST_F(TokenChanges, TheAnswerThatIsComputedIsSent) {
  Gate gate;
  Loopback loopback(std::ref(gate), options_);
  const Client client = Kitchen(loopback);
  const auto stream = client.OpenStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  ASSERT_TRUE(stream->Send(request));
  gate.WaitUntilBegun();
  ASSERT_TRUE(stream->Send(request));
  WriteTokens(std::string("hall ") + kOther);
  loopback.server.ReloadAccess();
  gate.Let();
  EXPECT_TRUE(stream->Receive());
  ExpectEnd(*stream, "the token is not known");
}

TEST_F(TokenChanges, TheSchemeIsTakenInAnyCase) {
  const Loopback loopback(FindOne, options_);
  const auto stub = v1::DetectionService::NewStub(
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials()));
  const auto code_with = [&](const std::string& authorization) {
    grpc::ClientContext context;
    context.AddMetadata("authorization", authorization);
    v1::GetServerInfoResponse info;
    return stub->GetServerInfo(&context, {}, &info).error_code();
  };
  for (const char* scheme : {"Bearer", "bearer", "BEARER"}) {
    EXPECT_EQ(code_with(std::string(scheme) + " let-me-in"), grpc::StatusCode::OK) << scheme;
  }
  EXPECT_EQ(code_with("Basic let-me-in"), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_EQ(code_with("Bearer"), grpc::StatusCode::UNAUTHENTICATED);
}

}  // namespace
}  // namespace fovea::testing
