// The server's executable: start, stop and what it says when it cannot.
#include "tests/e2e/server_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "client/client.h"
#include "tests/e2e/config_file.h"
#include "tests/server/frames.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

TEST(ServerProcess, PrintsItsAddressAndStopsOnSigterm) {
  Process server({FOVEA_SERVER, "--listen", "127.0.0.1:0"});
  const std::string line = server.ReadLine();
  EXPECT_THAT(line, MatchesRegex("listening on 127\\.0\\.0\\.1:[1-9][0-9]*"));
  client::Client(line.substr(line.rfind(' ') + 1)).WaitUntilReady(kPatience);
  server.Signal(SIGTERM);
  const Finished finished = server.Wait();
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
                            ": the port is in use\n");
}

TEST(ServerProcess, SaysThatThePortOfTheMetricsIsTaken) {
  ServerProcess server;
  const Finished second =
      Execute({FOVEA_SERVER, "--listen", "127.0.0.1:0", "--metrics-listen", server.address()});
  EXPECT_NE(second.exit_code, 0);
  EXPECT_EQ(second.out, "");
  EXPECT_EQ(second.err, "fovea-server: --metrics-listen: cannot listen on " + server.address() +
                            ": Address already in use\n");
}

TEST(ServerProcess, SaysWhyTheMetricsHaveNoPort) {
  const Finished finished =
      Execute({FOVEA_SERVER, "--listen", "127.0.0.1:0", "--metrics-listen", "192.0.2.1:0"});
  EXPECT_NE(finished.exit_code, 0);
  EXPECT_EQ(finished.err,
            "fovea-server: --metrics-listen: cannot listen on 192.0.2.1:0: Cannot assign requested "
            "address\n");
}

TEST(ServerProcess, RefusesBadFlagsInOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--no-such-flag"}, "--no-such-flag"},
      {{"--lisen", "3"}, "--lisen; did you mean --listen? (--help lists the flags)"},
      {{"--show", "lisen"}, "--show: \"lisen\" is no key"},
      {{"--listen", "nowhere"}, "--listen: \"nowhere\""},
      {{"--max-pixels", "many"},
       "--max-pixels: \"many\" is not a whole number between 1 and 100000000"},
      {{"--max-streams", "99999999999"}, "is not a whole number between 1 and 10000"},
      {{"--trace-endpoint", "https://a?key=secret"}, "--trace-endpoint: \"https://a?...\" is not"},
      {{"--tokens", "/"}, "--tokens: cannot read /: Is a directory"},
      {{"--tokens", "/no"}, "--tokens: cannot read /no: No such file or directory"},
      {{"--config", "/no"}, "--config: cannot read /no: No such file or directory"},
      {{"--observers", "/"}, "--observers: cannot read /: Is a directory"},
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

// Without the look at what they are, each would wait for somebody who writes, or have no end.
TEST(ServerProcess, WantsFilesThatItCanReadAgain) {
  const TemporaryFolder folder;
  const std::string pipe = folder.At("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), S_IRUSR | S_IWUSR), 0);
  for (const std::string& path : {pipe, std::string("/dev/zero")}) {
    for (std::vector<std::string> flags : {std::vector<std::string>{"--config"},
                                           {"--tokens"},
                                           {"--tls-cert", "/dev/null", "--tls-key"}}) {
      const std::string error = flags.back() + ": " + path + " is no file that can be read again";
      flags.insert(flags.begin(), {FOVEA_SERVER, "--check-config"});
      flags.push_back(path);
      const Finished refused = Execute(flags);
      EXPECT_EQ(refused.exit_code, 1) << error;
      EXPECT_THAT(refused.err, HasSubstr(error));
    }
  }
  const std::string large = folder.Write("large", "");
  std::filesystem::resize_file(large, (std::uintmax_t{16} << 20) + 1);
  for (const std::string flag : {"--config", "--tokens"}) {
    EXPECT_THAT(Execute({FOVEA_SERVER, "--check-config", flag, large}).err,
                HasSubstr(flag + ": " + large + " has more than 16 MiB"));
  }
}

TEST(ServerProcess, TheSampleConfigurationIsValid) {
  const Finished sample = Execute(
      {FOVEA_SERVER, "--check-config", "--config", FOVEA_SOURCE_DIR "/deploy/fovea-server.toml"});
  EXPECT_EQ(sample.exit_code, 0) << sample.err;
}

TEST(ServerProcess, TheConfigurationOfTheImageWantsProtection) {
  const std::vector<std::string> image{FOVEA_SERVER, "--config",
                                       FOVEA_SOURCE_DIR "/deploy/container/fovea-server.toml"};
  const Finished open = Execute(image);
  EXPECT_EQ(open.exit_code, 1);
  EXPECT_THAT(open.err, StartsWith("fovea-server: --listen: \"0.0.0.0:50051\" is open to other "
                                   "machines; give --tls-cert, --tls-key and either "
                                   "--tls-client-ca or --tokens, or --insecure"));
  std::vector<std::string> insecure = image;
  insecure.insert(insecure.end(), {"--insecure", "--check-config"});
  EXPECT_EQ(Execute(insecure).out, "the configuration is valid\n");
}

TEST(ServerProcess, IsAskedForItsHealthByTheImage) {
  const std::string check = FOVEA_SOURCE_DIR "/deploy/container/fovea-health";
  const HeldAddress metrics;
  ServerProcess server({"--metrics-listen", metrics.Text()});
  EXPECT_THAT(server.process().ReadLine(), HasSubstr(metrics.Text()));
  const Finished alive = Execute({check, metrics.Port()});
  EXPECT_EQ(alive.exit_code, 0) << alive.err;
  EXPECT_EQ(alive.out, "/livez says 200\n");
  server.process().Signal(SIGTERM);
  server.process().Wait();
  EXPECT_NE(Execute({check, metrics.Port()}).exit_code, 0);

  // The port is free again; this time the check finds it by itself.
  const ConfigFile file("metrics-listen = \"0.0.0.0:" + metrics.Port() + "\"\n");
  ServerProcess next({"--config", file.path()});
  EXPECT_THAT(next.process().ReadLine(), HasSubstr(metrics.Port()));
  const std::string pid = "SERVER_PID=" + std::to_string(next.process().pid());
  const Finished found = Execute({"/usr/bin/env", pid, check});
  EXPECT_EQ(found.out, "/livez says 200\n") << found.err;
}

TEST(ServerProcess, IsNotHealthyForTheImageWhereNobodyCanBeAsked) {
  ServerProcess server;
  const std::string pid = "SERVER_PID=" + std::to_string(server.process().pid());
  const Finished silent =
      Execute({"/usr/bin/env", pid, FOVEA_SOURCE_DIR "/deploy/container/fovea-health"});
  EXPECT_EQ(silent.exit_code, 1);
  EXPECT_EQ(silent.out, "metrics-listen is empty: nobody to ask\n");
}

TEST(ServerProcess, IsReplacedInMidStreamAfterKill) {
  client::ClientOptions options{.timeout = kPatience};
  options.retry.max_attempts = 1000;
  auto server = std::make_optional<ServerProcess>();
  const std::string address = server->address();
  const auto stream = client::Client(address, options).OpenResumingStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  stream->Send(request);
  EXPECT_EQ(stream->Receive()->lost, 0U);
  server->process().Signal(SIGKILL);
  server->process().Wait();
  stream->Send(request);
  Process replacement({FOVEA_SERVER, "--listen", address});
  replacement.ReadLine();
  std::atomic<bool> answered = false;
  std::jthread sender([&] {
    while (!answered) {
      stream->Send(request);
      std::this_thread::yield();
    }
  });
  EXPECT_GE(stream->Receive()->lost, 1U);
  answered = true;
}

TEST(ServerProcess, ExplainsItself) {
  const Finished help = Execute({FOVEA_SERVER, "--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* flag : {"--listen", "--max-message-mib", "--max-pixels", "--log-level"}) {
    EXPECT_THAT(help.out, HasSubstr(flag));
  }
  EXPECT_THAT(help.out, HasSubstr("--max-streams INT:1 to 10000=1000\n"));
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
  EXPECT_THAT(page, HasSubstr(options.out))
      << "docs/options.md is to hold what fovea-server --list-options prints";
}

}  // namespace
}  // namespace fovea::testing
