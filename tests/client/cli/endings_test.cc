// What a file is by its ending, in letters of either case.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core/mat.hpp>
#include <stdexcept>
#include <string>

#include "client/cli/bag/bag_files.h"
#include "client/cli/bundled_frames.h"
#include "client/cli/files.h"
#include "client/cli/output_check.h"
#include "tests/support/temporary_folder.h"

namespace fovea::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Outputs Only(std::string Outputs::*output, const std::string& path) {
  Outputs outputs;
  outputs.*output = path;
  return outputs;
}

TEST(Endings, OfOutputsHaveEitherCase) {
  const testing::TemporaryFolder folder;
  for (const char* cloud : {"o.pcd", "o.PCD", "o.Ply"}) {
    CheckOutputs(Only(&Outputs::cloud, folder.At(cloud)), {});
  }
  EXPECT_THROW(CheckOutputs(Only(&Outputs::cloud, folder.At("o.PCB")), {}), std::invalid_argument);
  CheckOutputs(Only(&Outputs::labels, folder.At("l.PNG")), {});
  EXPECT_THROW(CheckOutputs(Only(&Outputs::labels, folder.At("l.JPG")), {}), std::invalid_argument);
  for (const char* kind : {"ply", "PLY", "PCD"}) CheckCloudFormat(kind);
  EXPECT_THROW(CheckCloudFormat("P"), std::invalid_argument);
}

TEST(Endings, SayWhichCloudIsWritten) {
  const testing::TemporaryFolder folder;
  WriteImage(folder.At("c.png"), cv::Mat::ones(3, 4, CV_8UC3));
  WriteImage(folder.At("d.png"), cv::Mat::ones(3, 4, CV_16UC1));
  v1::DetectRequest request;
  request.mutable_frame()->mutable_color()->set_data(ReadFile(folder.At("c.png")));
  request.mutable_frame()->mutable_depth()->set_data(ReadFile(folder.At("d.png")));
  FrameSettings settings;
  settings.intrinsics.set_fx(4);
  settings.intrinsics.set_fy(4);
  v1::Detections detections;
  detections.set_width(4);
  detections.set_height(3);
  const auto written = [&](const char* name) {
    WriteOutputs(Only(&Outputs::cloud, folder.At(name)), {}, settings, request, detections);
    return ReadFile(folder.At(name));
  };
  EXPECT_THAT(written("o.PCD"), HasSubstr("VERSION 0.7"));
  EXPECT_THAT(written("o.PLY"), StartsWith("ply\n"));
}

TEST(Endings, OfInputsHaveEitherCase) {
  EXPECT_TRUE(IsBag("a.mcap") && IsBag("B.MCAP") && IsBag("a.db3") && IsBag("B.DB3"));
  EXPECT_TRUE(IsBundle("a.zip") && IsBundle("B.ZIP"));
  EXPECT_FALSE(IsBag("mcap") || IsBundle("zip") || IsBundle("a.zip.d"));
}

}  // namespace
}  // namespace fovea::cli
