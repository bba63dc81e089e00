// What the server does on signals, beside ending.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>

#include "client/client.h"
#include "tests/e2e/server_process.h"
#include "tests/server/frames.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// The hold is long: only a second signal ends it before the test's patience does.
TEST(ServerSignals, HoldsBeforeItStops) {
  ServerProcess server({"--hold-s", "3600"});
  const client::Client client(server.address(), {.timeout = kPatience});
  client.WaitUntilReady(kPatience);
  server.process().Signal(SIGTERM);
  // Not by asking alone: so many calls at once, by who has sent no frame, are a flood.
  server.process().AwaitError("stopping: serving on for 3600 s");
  while (client.IsServing()) std::this_thread::yield();
  server.process().Signal(SIGTERM);
  server.process().AwaitError("a second signal: no longer serving on");
  EXPECT_EQ(server.process().Wait().exit_code, 0);
}

TEST(ServerSignals, HoldsOnWhereASecondSignalIsNoneToStop) {
  ServerProcess server({"--hold-s", "3600"});
  client::ClientOptions once{.timeout = kPatience};
  once.retry.max_attempts = 1;
  server.process().Signal(SIGTERM);
  server.process().AwaitError("stopping: serving on for 3600 s");
  server.process().Signal(SIGSTOP);
  server.process().Signal(SIGHUP);
  server.process().Signal(SIGCONT);
  for (int i = 0; i < 20; ++i) client::Client(server.address(), once).Detect(TestRequest());
  server.process().Signal(SIGINT);
  EXPECT_EQ(server.process().Wait().exit_code, 0);
}

TEST(ServerSignals, GoesOnAfterThoseThatDoNothing) {
  ServerProcess server;
  const client::Client client(server.address(), {.timeout = kPatience});
  for (const auto& [number, name] :
       {std::pair(SIGUSR1, "SIGUSR1"), std::pair(SIGUSR2, "SIGUSR2")}) {
    server.process().Signal(number);
    server.process().AwaitError(std::string(name) + " does nothing here");
  }
  EXPECT_NO_THROW(client.Detect(TestRequest()));
  server.process().Signal(SIGTERM);
  const Finished finished = server.process().Wait();
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_THAT(finished.err, HasSubstr("info ended: 0 calls were cancelled (--drain-timeout-s)\n"));
}

TEST(ServerSignals, ReadsItsLogLevelAgain) {
  const std::string path = ::testing::TempDir() + "fovea_level_" + std::to_string(getpid());
  const auto write = [&](const char* text) { std::ofstream(path) << text; };
  write("log-level = \"warn\"\n");
  ServerProcess server({"--config", path, "--metrics-listen", "127.0.0.1:0"});
  EXPECT_THAT(server.process().ReadLine(), StartsWith("metrics at http://127.0.0.1:"));
  write("log-level = \"nonsense\"\n");
  server.process().Signal(SIGHUP);
  server.process().AwaitError("the configuration stays as it was: --log-level: \"nonsense\"");
  write("log-level = \"info\"\n");
  server.process().Signal(SIGHUP);
  server.process().AwaitError("log level is info");
  server.process().Signal(SIGTERM);
  const Finished finished = server.process().Wait();
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_THAT(finished.err, HasSubstr("info stopping"));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace fovea::testing
