// The same frame gives the same answer whatever the processor can do: the C library has variants of
// its functions with fused multiply-add, whose results differ in the last bit, OpenCV has its own
// for each generation of processors, and so have our own loops.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/core/frame_file.h"
#include "tests/e2e/process.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"
#include "tests/support/sensor.h"

namespace fovea {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kAsItIs = "FOVEA_TEST=";
const std::string kWithoutFma = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4";
const std::string kPlainOpenCv = "OPENCV_CPU_DISABLE=SSE4.1,SSE4.2,FP16,AVX,AVX2,AVX512-SKX";

// Frames of all kinds of scenes, while it lives.
class FrameFile {
 public:
  FrameFile()
      : path_(std::filesystem::temp_directory_path() /
              ("fovea_same_answer_" + std::to_string(getpid()))) {
    std::ofstream file(path_, std::ios::binary);
    for (const std::string& kind : scenes::SceneKinds()) {
      const scenes::Scene scene = scenes::RandomScene(kind, 3, {320, 240});
      WriteFrame(file, scenes::MakeFrame(scene, scenes::SensorKind::kKinect, 3).frame);
    }
  }
  ~FrameFile() { std::filesystem::remove(path_); }
  FrameFile(const FrameFile&) = delete;
  FrameFile& operator=(const FrameFile&) = delete;

  std::string path() const { return path_; }

 private:
  const std::filesystem::path path_;
};

std::string Digest(const std::vector<std::string>& environment,
                   const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"/usr/bin/env"};
  command.insert(command.end(), environment.begin(), environment.end());
  command.emplace_back(FOVEA_ANSWER_DIGEST);
  command.insert(command.end(), arguments.begin(), arguments.end());
  const testing::Finished finished = testing::Execute(command);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return finished.out;
}

TEST(SameAnswer, WhateverTheProcessorCanDo) {
  const FrameFile frames;
  const std::string as_it_is = Digest({kAsItIs}, {frames.path()});
  EXPECT_THAT(as_it_is, HasSubstr("default"));
  EXPECT_EQ(Digest({kWithoutFma}, {frames.path()}), as_it_is);
  EXPECT_EQ(Digest({kPlainOpenCv}, {frames.path()}), as_it_is);
}

TEST(SameAnswer, OnEachInstructionSet) {
  const FrameFile frames;
  const std::string as_it_is = Digest({kAsItIs}, {frames.path()});
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    EXPECT_EQ(Digest({kAsItIs}, {frames.path(), std::to_string(target)}), as_it_is)
        << hwy::TargetName(target);
  }
}

// Else the first test compares a thing with itself.
TEST(SameAnswer, IsAskedOfALibraryThatDiffers) {
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no FMA";
  EXPECT_THAT(Digest({kWithoutFma}, {}), Not(Digest({kAsItIs}, {})));
}

}  // namespace
}  // namespace fovea
