// The server's executable: start, stop and what it says when it cannot.
#include "tests/e2e/server_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <string>

#include "client/client.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

constexpr std::chrono::minutes kPatience{1};

TEST(ServerProcess, PrintsItsAddressAndStopsOnSigterm) {
  ServerProcess server;
  EXPECT_THAT(server.line(), MatchesRegex("listening on 127\\.0\\.0\\.1:[1-9][0-9]*"));
  client::Client(server.address()).WaitUntilReady(kPatience);
  server.process().Signal(SIGTERM);
  const Finished finished = server.process().Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
}

TEST(ServerProcess, StopsOnSigint) {
  ServerProcess server;
  server.process().Signal(SIGINT);
  EXPECT_EQ(server.process().Wait().exit_code, 0);
}

TEST(ServerProcess, SaysThatThePortIsTaken) {
  ServerProcess server;
  const Finished second = Execute({FOVEA_SERVER, "--listen", server.address()});
  EXPECT_NE(second.exit_code, 0);
  EXPECT_EQ(second.out, "");
  EXPECT_EQ(second.err, "fovea-server: --listen: cannot listen on " + server.address() +
                            ": the port is in use or the address is not one of this machine\n");
}

TEST(ServerProcess, RefusesBadFlagsInOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--no-such-flag"}, "--no-such-flag"},
      {{"--listen", "nowhere"}, "--listen: \"nowhere\""},
      {{"--max-pixels", "many"}, "--max-pixels"},
      {{"--max-message-mib", "4096"}, "--max-message-mib: 4096 is not between 1 and 1024"}};
  for (auto [arguments, error] : cases) {
    arguments.insert(arguments.begin(), FOVEA_SERVER);
    const Finished finished = Execute(arguments);
    EXPECT_NE(finished.exit_code, 0) << error;
    EXPECT_THAT(finished.err, StartsWith("fovea-server: "));
    EXPECT_THAT(finished.err, HasSubstr(error));
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  }
}

TEST(ServerProcess, ExplainsItself) {
  const Finished help = Execute({FOVEA_SERVER, "--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* flag : {"--listen", "--max-message-mib", "--max-pixels", "--log-level"}) {
    EXPECT_THAT(help.out, HasSubstr(flag));
  }
  const Finished version = Execute({FOVEA_SERVER, "--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, MatchesRegex("fovea-server [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(ServerProcess, ListsTheOptionsAsTheDocumentationDoes) {
  const Finished options = Execute({FOVEA_SERVER, "--list-options"});
  EXPECT_EQ(options.exit_code, 0);
  EXPECT_THAT(options.out, StartsWith("| option | range | default | paper |"));
  std::ifstream file(FOVEA_SOURCE_DIR "/docs/options.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(page, HasSubstr(options.out)) << "docs/options.md is out of date";
}

}  // namespace
}  // namespace fovea::testing
