#include "client/cli/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fovea::cli {
namespace {

using ::testing::HasSubstr;

std::string Text(grpc::StatusCode code, const std::string& message, const ConnectionFlags& flags) {
  return Explain(client::RpcError(grpc::Status(code, message)), flags, "30 s (--timeout)");
}

TEST(Explain, NamesTheLimitAndItsFlag) {
  EXPECT_EQ(Text(grpc::StatusCode::DEADLINE_EXCEEDED, "Deadline Exceeded", {}),
            "DEADLINE_EXCEEDED: no answer from 127.0.0.1:50051 within 30 s (--timeout)");
  EXPECT_EQ(DefaultLimit(), "10 s");
}

TEST(Explain, NamesTheFlagOfTheToken) {
  ConnectionFlags flags;
  EXPECT_EQ(Text(grpc::StatusCode::UNAUTHENTICATED, "a token is needed", flags),
            "UNAUTHENTICATED: a token is needed; give it with --token-file");
  flags.token_file = "t";
  EXPECT_EQ(Text(grpc::StatusCode::UNAUTHENTICATED, "the token is not known", flags),
            "UNAUTHENTICATED: the token is not known (--token-file t)");
}

TEST(Explain, SaysWhatTheServerWants) {
  const auto text = [](const std::string& message, const ConnectionFlags& flags) {
    return Text(grpc::StatusCode::UNAVAILABLE, message, flags);
  };
  ConnectionFlags flags;
  EXPECT_THAT(text("Connection refused", flags), HasSubstr("is fovea-server running there?"));
  EXPECT_THAT(text("Socket closed", flags), HasSubstr("TLS (--tls-ca)?"));
  flags.tls_ca = "ca.pem";
  EXPECT_THAT(text("Socket closed", flags), HasSubstr("(--tls-cert and --tls-key)?"));
  EXPECT_THAT(text("SSL routines::wrong version number", flags), HasSubstr("does not speak TLS"));
  EXPECT_THAT(text("SSL routines::certificate verify failed", flags),
              HasSubstr("--tls-ca: ca.pem does not certify the server"));
  EXPECT_THAT(text("Peer name localhost is not in peer certificate", flags),
              HasSubstr("is for other names"));
  EXPECT_THAT(text("empty address list: ", flags), HasSubstr("is fovea-server running there?"));
  flags.tls_cert = "robot.pem";
  flags.tls_key = "other.key";
  EXPECT_THAT(text("empty address list: ", flags),
              HasSubstr("--tls-key: other.key does not hold the key, in PEM, of robot.pem"));
}

TEST(Explain, NamesAServiceOfAnotherKind) {
  EXPECT_THAT(Text(grpc::StatusCode::UNAVAILABLE, "Failed parsing HTTP/2", {}),
              HasSubstr("what answers at 127.0.0.1:50051 is no fovea-server"));
  EXPECT_EQ(Text(grpc::StatusCode::UNIMPLEMENTED, "Method not found!", {}),
            "UNIMPLEMENTED: Method not found!; is a fovea-server of this version at "
            "127.0.0.1:50051?");
}

TEST(Explain, LeavesTheRest) {
  EXPECT_EQ(Text(grpc::StatusCode::INVALID_ARGUMENT, "frame.color: is empty", {}),
            "INVALID_ARGUMENT: frame.color: is empty");
  EXPECT_EQ(Text(grpc::StatusCode::RESOURCE_EXHAUSTED, "the queue is full", {}),
            "RESOURCE_EXHAUSTED: the queue is full");
}

}  // namespace
}  // namespace fovea::cli
