// What the server's executable tells systemd, whose place these tests take.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <string>
#include <vector>

#include "client/client.h"
#include "server/connections/file_descriptor.h"
#include "tests/e2e/server_process.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::MatchesRegex;

const std::string kReady = "READY=1";
const std::string kAlive = "WATCHDOG=1";
const std::string kStopping = "STOPPING=1";

// The socket that systemd listens on.
class ServiceManager {
 public:
  ServiceManager() : socket_(socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
    path_.copy(address.sun_path, sizeof address.sun_path - 1);
    EXPECT_EQ(bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    const timeval patience{.tv_sec = std::chrono::seconds(kPatience).count(), .tv_usec = 0};
    setsockopt(socket_.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }

  // The command line of a server on a free port that tells this one.
  std::vector<std::string> CommandLine(const std::vector<std::string>& flags = {},
                                       const std::vector<std::string>& environment = {}) const {
    std::vector<std::string> words{"/usr/bin/env", "NOTIFY_SOCKET=" + path_};
    words.insert(words.end(), environment.begin(), environment.end());
    words.insert(words.end(), {FOVEA_SERVER, "--listen", "127.0.0.1:0", "--log-level", "error"});
    words.insert(words.end(), flags.begin(), flags.end());
    return words;
  }

  // What it is told next; empty where nothing comes.
  std::string Receive() const { return ReceiveWith(0); }
  // All that it has been told and not received yet.
  std::vector<std::string> ReceiveRest() const {
    std::vector<std::string> rest;
    for (std::string said; !(said = ReceiveWith(MSG_DONTWAIT)).empty();) rest.push_back(said);
    return rest;
  }

 private:
  std::string ReceiveWith(int flags) const {
    std::array<char, 4096> buffer{};
    const ssize_t size = recv(socket_.get(), buffer.data(), buffer.size(), flags);
    return size < 0 ? "" : std::string(buffer.data(), static_cast<std::size_t>(size));
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.At("notify");
  server::FileDescriptor socket_;
};

// Without checks of itself, which would come in between.
const std::vector<std::string> kNoCheck{"--self-check-s", "0"};

TEST(ServiceManager, IsToldWhenTheServerIsReadyAndWhenItStops) {
  const ServiceManager systemd;
  Process server(systemd.CommandLine(kNoCheck));
  EXPECT_EQ(systemd.Receive(), kReady);
  const std::string line = server.ReadLine();
  client::ClientOptions once{.timeout = kPatience};
  once.retry.max_attempts = 1;
  EXPECT_TRUE(client::Client(line.substr(line.rfind(' ') + 1), once).IsServing());

  server.Signal(SIGTERM);
  EXPECT_EQ(systemd.Receive(), kStopping);
  const Finished finished = server.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(systemd.ReceiveRest(), IsEmpty());
}

TEST(ServiceManager, IsToldNothingByAServerThatCannotServe) {
  const ServiceManager systemd;
  const ServerProcess other;
  const Finished finished = Execute(systemd.CommandLine({"--listen", other.address()}));
  EXPECT_NE(finished.exit_code, 0);
  EXPECT_THAT(systemd.ReceiveRest(), IsEmpty());
}

TEST(ServiceManager, IsToldOfEveryReload) {
  const ServiceManager systemd;
  Process server(systemd.CommandLine(kNoCheck));
  EXPECT_EQ(systemd.Receive(), kReady);
  for (int i = 0; i < 2; ++i) {
    server.Signal(SIGHUP);
    EXPECT_THAT(systemd.Receive(), MatchesRegex("RELOADING=1\nMONOTONIC_USEC=[1-9][0-9]*"));
    EXPECT_EQ(systemd.Receive(), kReady);
  }
}

TEST(ServiceManager, IsToldThatTheServerIsAliveAsOftenAsItsWatchdogAsks) {
  const ServiceManager systemd;
  // Of its own accord it would not check itself again before the hour is over, or at all.
  for (const char* period : {"3600", "0"}) {
    Process server(systemd.CommandLine({"--self-check-s", period}, {"WATCHDOG_USEC=3000000"}));
    int alive = 0, ready = 0;
    while (alive < 2 || ready == 0) {
      const std::string said = systemd.Receive();
      ASSERT_TRUE(said == kAlive || said == kReady) << said;
      ++(said == kAlive ? alive : ready);
    }
    EXPECT_EQ(ready, 1);
    server.Signal(SIGTERM);
    while (systemd.Receive() == kAlive) {
    }
    EXPECT_EQ(server.Wait().exit_code, 0);
    EXPECT_THAT(systemd.ReceiveRest(), IsEmpty());
  }
}

}  // namespace
}  // namespace fovea::testing
