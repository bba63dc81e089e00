// Folders of frames whose server goes, or hangs, on the way.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>

#include "tests/e2e/cli_fixture.h"

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class AwayServerTest : public CliTest {
 protected:
  // One frame after the other.
  Process DetectFolder(const std::string& timeout_s) {
    return Process({FOVEA_CLI, "detect", "--server", server_.address(), "--intrinsics",
                    "30,30,15.5,11.5", "--timeout", timeout_s, "--jobs", "1", "--input", Folder(),
                    "--output", At("out")});
  }
};

// Each of them tried to connect five times, with pauses: an hour for 10,000 frames.
TEST_F(AwayServerTest, EndsSoonWhereTheServerHasGone) {
  WriteFrame("b");
  for (int i = 0; i < 60; ++i) {
    for (const char* image : {"_color.png", "_depth.png"}) {
      fs::create_symlink(At(std::string("b") + image), At("c" + std::to_string(i) + image));
    }
  }
  Process run = DetectFolder("1");
  EXPECT_THAT(run.ReadLine(), StartsWith("1/62  a"));
  server_.process().Signal(SIGKILL);
  server_.process().Wait();
  const auto gone = std::chrono::steady_clock::now();
  const Finished finished = run.Wait();
  EXPECT_LT(std::chrono::steady_clock::now() - gone, std::chrono::seconds(15));
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_THAT(finished.err, HasSubstr("fovea: c59: no server answers at " + server_.address()));
}

// It takes connections and calls. Each frame waited for its whole time.
TEST_F(AwayServerTest, GivesUpWhereTheServerHangs) {
  for (int i = 0; i < 30; ++i) WriteFrame("b" + std::to_string(i));
  Process run = DetectFolder("1");
  EXPECT_THAT(run.ReadLine(), StartsWith("1/31  a"));
  server_.process().Signal(SIGSTOP);
  const Finished finished = run.Wait();
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_THAT(finished.out, Not(HasSubstr("10/31"))) << "it goes on and on";
  EXPECT_THAT(finished.err, HasSubstr("fovea: the server hangs: 3 frames in turn had no answer"));
  EXPECT_THAT(finished.err, HasSubstr("--resume"));
}

TEST_F(AwayServerTest, GoesOnWhereTheServerHungForAWhile) {
  for (int i = 0; i < 9; ++i) WriteFrame("b" + std::to_string(i));
  Process run = DetectFolder("3");
  EXPECT_THAT(run.ReadLine(), StartsWith("1/10  a"));
  server_.process().Signal(SIGSTOP);
  std::string line;
  for (int failed = 0; failed < 3; failed += line.ends_with(": failed") ? 1 : 0) {
    line = run.ReadLine();
    ASSERT_NE(line, "");
  }
  server_.process().Signal(SIGCONT);
  const Finished finished = run.Wait();
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_THAT(finished.out, HasSubstr("3 failed"));
}

}  // namespace
}  // namespace fovea::testing
