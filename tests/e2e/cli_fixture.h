// The command-line client on files, against the real server.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/e2e/server_process.h"
#include "tests/server/frames.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {

class CliTest : public ::testing::Test {
 protected:
  CliTest() { WriteFrame("a"); }

  std::string Folder() const { return folder_.Path(); }
  std::string At(const std::string& name) const { return folder_.At(name); }
  void Write(const std::string& name, const std::string& bytes) const {
    folder_.Write(name, bytes);
  }

  void WriteFrame(const std::string& name) const {
    Write(name + "_color.png", PngOf(TestColor()));
    Write(name + "_depth.png", PngOf(TestDepth()));
  }

  Finished Detect(std::vector<std::string> flags) {
    flags.insert(flags.begin(), {FOVEA_CLI, "detect", "--server", server_.address(), "--intrinsics",
                                 "30,30,15.5,11.5"});
    return Execute(flags);
  }

  Finished DetectFrame(std::vector<std::string> flags = {}) {
    flags.insert(flags.begin(), {"--color", At("a_color.png"), "--depth", At("a_depth.png")});
    return Detect(flags);
  }

  static void ExpectOneLineError(const Finished& finished, const std::string& text) {
    EXPECT_EQ(finished.exit_code, 1);
    EXPECT_THAT(finished.err, ::testing::StartsWith("fovea: "));
    EXPECT_THAT(finished.err, ::testing::HasSubstr(text));
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  }

  ServerProcess server_;
  TemporaryFolder folder_;
};

}  // namespace fovea::testing
