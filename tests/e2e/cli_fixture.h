// The command-line client on files, against the real server.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/e2e/server_process.h"
#include "tests/server/frames.h"

namespace fovea::testing {

inline void Write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

class CliTest : public ::testing::Test {
 protected:
  CliTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "fovea_cli_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    WriteFrame("a");
  }
  ~CliTest() override { std::filesystem::remove_all(folder_); }

  std::string At(const std::string& name) const { return (folder_ / name).string(); }

  void WriteFrame(const std::string& name) const {
    Write(At(name + "_color.png"), PngOf(TestColor()));
    Write(At(name + "_depth.png"), PngOf(TestDepth()));
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
  std::filesystem::path folder_;
};

}  // namespace fovea::testing
