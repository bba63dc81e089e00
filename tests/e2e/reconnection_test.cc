// A client finds a server that is back, without anybody's help.
//
// gRPC reads a new connection only while somebody waits for its channel or for a call on it, and
// besides once every 5 s, in the background. With that switched off, a client that merely sleeps
// between its attempts hardly ever gets through, however long it tries. The servers are processes
// of their own, and nothing else in this one uses gRPC: a server's threads would read for the
// client.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>

#include "client/client.h"
#include "tests/e2e/server_process.h"
#include "tests/server/frames.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;

// gRPC looks at it when it starts, in the first test.
[[maybe_unused]] const int kNobodyReads =
    setenv("GRPC_CLIENT_CHANNEL_BACKUP_POLL_INTERVAL_MS", "0", 1);

// The pauses are those of the defaults.
client::ClientOptions Stubborn() {
  client::ClientOptions options{.timeout = kPatience};
  options.retry.max_attempts = 1000;
  return options;
}

v1::DetectStreamRequest StreamFrame() {
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  return request;
}

class Reconnection : public ::testing::Test {
 protected:
  void Kill() {
    server_.process().Signal(SIGKILL);
    server_.process().Wait();
  }

  // A new server at the same address.
  Process Replacement() const { return Process({FOVEA_SERVER, "--listen", address_}); }

  bool HasAStream() const {
    return Execute({FOVEA_CLI, "info", "--server", address_}).out.find("\"streams\": \"1\"") !=
           std::string::npos;
  }

  ServerProcess server_;
  const std::string address_ = server_.address();
  const client::Client client_{address_, Stubborn()};
};

TEST_F(Reconnection, OfAStreamThatSendsNothing) {
  const auto stream = client_.OpenResumingStream(kPatience);
  stream->Send(StreamFrame());
  EXPECT_TRUE(stream->Receive());
  std::atomic<bool> ended = false;
  std::jthread receiver([&] {
    EXPECT_NO_THROW(EXPECT_EQ(stream->Receive()->response.sequence(), 1U));
    ended = true;
  });
  Kill();
  Process replacement = Replacement();
  EXPECT_THAT(replacement.ReadLine(), HasSubstr("listening"));
  while (!HasAStream() && !ended) {
  }
  stream->Send(StreamFrame());
  receiver.join();  // before the server ends
}

TEST_F(Reconnection, OfCalls) {
  EXPECT_NO_THROW(client_.GetServerInfo());
  Kill();
  std::jthread caller([&] { EXPECT_NO_THROW(client_.GetServerInfo()); });
  Process replacement = Replacement();
  EXPECT_THAT(replacement.ReadLine(), HasSubstr("listening"));
  caller.join();  // before the server ends
}

TEST_F(Reconnection, IsCancelled) {
  const std::chrono::hours hang(1);
  const auto stream = client::Client(address_, {.timeout = hang}).OpenResumingStream(hang);
  Kill();
  std::jthread receiver([&] { EXPECT_THROW(stream->Receive(), client::RpcError); });
  stream->Cancel();
}

}  // namespace
}  // namespace fovea::testing
