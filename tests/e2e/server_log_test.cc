// What the server's executable logs, and what becomes of it when nobody takes that.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "client/client.h"
#include "tests/e2e/server_process.h"
#include "tests/server/frames.h"
#include "tests/support/certificates.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

client::ClientOptions OnceOnly() {
  client::ClientOptions options{.timeout = kPatience};
  options.retry.max_attempts = 1;
  return options;
}

// A good frame and a bad one.
void DetectTwice(const std::string& address) {
  const client::Client client(address, OnceOnly());
  client.WaitUntilReady(kPatience);
  EXPECT_NO_THROW(client.Detect(TestRequest()));
  EXPECT_THROW(client.Detect({}), client::RpcError);
}

std::string AddressIn(const std::string& line) { return line.substr(line.rfind(' ') + 1); }

Finished Stop(Process& server) {
  server.Signal(SIGTERM);
  return server.Wait();
}

class Pipe {
 public:
  Pipe() { EXPECT_EQ(pipe2(ends_.data(), O_CLOEXEC), 0); }
  ~Pipe() {
    CloseReader();
    close(ends_[1]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int writer() const { return ends_[1]; }
  void CloseReader() {
    if (ends_[0] >= 0) close(std::exchange(ends_[0], -1));
  }
  void Fill() const {
    const std::string page(4096, 'x');
    fcntl(ends_[1], F_SETFL, O_NONBLOCK);
    while (write(ends_[1], page.data(), page.size()) > 0) {
    }
    fcntl(ends_[1], F_SETFL, 0);
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

const std::vector<std::string> kServer{FOVEA_SERVER, "--listen", "127.0.0.1:0"};

TEST(ServerLog, WhoseReaderHasGoneEndsNothing) {
  Pipe log;
  Process server(kServer, log.writer());
  const std::string address = AddressIn(server.ReadLine());
  log.CloseReader();
  DetectTwice(address);
  EXPECT_EQ(Stop(server).exit_code, 0);
}

TEST(ServerLog, ThatIsNotTakenHoldsUpNothing) {
  const Pipe log;
  log.Fill();
  Process server(kServer, log.writer());
  DetectTwice(AddressIn(server.ReadLine()));
  EXPECT_EQ(Stop(server).exit_code, 0);
}

TEST(ServerLog, ThatMayNotGrowEndsNothing) {
  Process server({"/bin/sh", "-c", "ulimit -f 1; exec \"$0\" \"$@\"", FOVEA_SERVER, "--listen",
                  "127.0.0.1:0"});
  DetectTwice(AddressIn(server.ReadLine()));
  EXPECT_EQ(Stop(server).exit_code, 0);
}

TEST(ServerLog, ClosedStreamsAreNoConnections) {
  const TemporaryFolder folder;
  const std::string address = "unix:" + folder.At("socket");
  Process server(
      {"/bin/sh", "-c", "exec \"$0\" \"$@\" <&- >&- 2>&-", FOVEA_SERVER, "--listen", address});
  DetectTwice(address);
  EXPECT_EQ(Stop(server).exit_code, 0);
}

TEST(ServerLog, BeginsWithVersionAndConfiguration) {
  ServerProcess server(
      {"--max-streams", "17", "--trace-endpoint", "http://127.0.0.1:1/v1/traces?key=secret"});
  const std::string log = Stop(server.process()).err;
  EXPECT_THAT(log, MatchesRegex("20[0-9-]+T[0-9:.]+[+-][0-9]+:[0-9]+ info fovea-server [0-9]+.*"));
  EXPECT_THAT(log, HasSubstr("info configuration "));
  EXPECT_THAT(log, HasSubstr(" listen=\"" + server.address() + "\""));
  EXPECT_THAT(log, HasSubstr(" max-streams=\"17\""));
  EXPECT_THAT(log, HasSubstr(" slow-ms=\"2000\""));
  EXPECT_THAT(log, HasSubstr(" trace-endpoint=\"http://127.0.0.1:1/v1/traces?...\""));
  EXPECT_THAT(log, Not(HasSubstr("secret")));
}

TEST(ServerLog, IsJsonWhereAskedFor) {
  ServerProcess server({"--log-format", "json", "--slow-ms", "1"});
  DetectTwice(server.address());
  std::istringstream lines(Stop(server.process()).err);
  std::vector<std::string> events, profiles;
  for (std::string line; std::getline(lines, line);) {
    const auto object = nlohmann::json::parse(line);
    EXPECT_TRUE(object.contains("time") && object.contains("level")) << line;
    events.push_back(object.value("event", "message"));
    if (events.back() == "listening") {
      EXPECT_EQ(object.at("address"), server.address());
    }
    if (events.back() == "slow") {
      // On a busy machine the frame that is refused is slow, too, and has none.
      profiles.push_back(object.value("profile", "none"));
      EXPECT_GT(object.at("total_ms"), 0);
    }
  }
  EXPECT_THAT(profiles, Contains("default"));
  for (const char* event : {"message", "configuration", "listening", "frame", "slow"}) {
    EXPECT_THAT(events, Contains(event));
  }
}

TEST(ServerLog, LimitsWhatCallersCanCause) {
  ServerProcess server({"--log-format", "json"});
  const client::Client client(server.address(), OnceOnly());
  client.WaitUntilReady(kPatience);
  constexpr int kCalls = 300;
  for (int i = 0; i < kCalls; ++i) EXPECT_THROW(client.Detect({}), client::RpcError);
  std::istringstream lines(Stop(server.process()).err);
  int written = 0, left_out = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto object = nlohmann::json::parse(line);
    if (object.value("event", "") == "frame") ++written;
    if (object.value("kind", "") == "frame INVALID_ARGUMENT") left_out += object.value("count", 0);
  }
  EXPECT_GE(written, 20);
  EXPECT_LT(written, kCalls);
  EXPECT_EQ(written + left_out, kCalls);
}

TEST(ServerLog, NamesHandshakesThatFail) {
  const TemporaryFolder folder;
  const PemPair pair = Authority().Issue("server");
  ServerProcess server({"--tls-cert", folder.Write("cert.pem", pair.certificate), "--tls-key",
                        folder.Write("key.pem", pair.key)});
  // In plain text.
  EXPECT_THROW(client::Client(server.address(), OnceOnly()).GetServerInfo(), client::RpcError);
  server.process().AwaitError("error grpc: Handshake failed");
  server.process().AwaitError(" ended before a call was let in, and a handshake has failed");
  EXPECT_THAT(Stop(server.process()).err, HasSubstr("warning connection of ipv4:127.0.0.1:"));
}

TEST(ServerLog, NamesKeysThatNeedARestart) {
  const TemporaryFolder folder;
  const std::string config = folder.Write("config", "max-streams = 7\nlog-level = \"info\"\n");
  ServerProcess server({"--config", config, "--drain-timeout-s", "1"});
  folder.Write("config", "max-streams = 8\nlog-level = \"warn\"\nslow-ms = 5\n");
  server.process().Signal(SIGHUP);
  server.process().AwaitError("log level is warn");
  const std::string log = Stop(server.process()).err;
  EXPECT_THAT(log, HasSubstr("max-streams: changed, needs a restart"));
  EXPECT_THAT(log, HasSubstr("slow-ms: changed, needs a restart"));
  EXPECT_THAT(log, Not(HasSubstr("log-level: changed")));
  EXPECT_THAT(log, Not(HasSubstr("drain-timeout-s: changed")));
}

TEST(ServerLog, NamesCertificatesThatDoNotFit) {
  const TemporaryFolder folder;
  const Authority authority;
  const PemPair pair = authority.Issue("server");
  ServerProcess server({"--tls-cert", folder.Write("cert.pem", pair.certificate), "--tls-key",
                        folder.Write("key.pem", pair.key), "--tls-reload-s", "1"});
  const PemPair renewed = authority.Issue("renewed");
  folder.Write("cert.pem", renewed.certificate);
  server.process().AwaitError("warning the certificates stay as they were: --tls-key: ");
  server.process().Signal(SIGHUP);
  server.process().AwaitError("error the configuration stays as it was: --tls-key: ");
  folder.Write("key.pem", renewed.key);
  server.process().AwaitError("subject \"CN=renewed\"");
}

}  // namespace
}  // namespace fovea::testing
