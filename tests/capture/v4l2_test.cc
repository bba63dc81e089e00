// Video nodes of the kernel, by a stand-in for its ioctl() (video_driver.cc).
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/capture/capture_process.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;

class V4l2Test : public CaptureTest {
 protected:
  V4l2Test() {
    folder_.Write("video-depth", "");
    folder_.Write("video-color", "");
    const CameraIntrinsics& k = frames_.front().frame.intrinsics;
    char text[160];
    std::snprintf(
        text, sizeof text,
        R"({"fx": %.9g, "fy": %.9g, "cx": %.9g, "cy": %.9g, "width": 320, "height": 240})", k.fx_px,
        k.fy_px, k.cx_px, k.cy_px);
    folder_.Write("k.json", text);
  }

  std::string Device() const { return "v4l2:" + At("video-depth") + "," + At("video-color"); }

  // Depth of the generated frames is registered.
  Finished Run(std::vector<std::string> flags, const std::string& faults = "") const {
    flags.insert(flags.end(), {"--device", Device(), "--calibration", At("k.json")});
    return Capture(Live(flags), {{"LD_PRELOAD", FOVEA_VIDEO_DRIVER},
                                 {"ASAN_OPTIONS", "verify_asan_link_order=0"},
                                 {"FOVEA_CAMERA_FAULTS", faults}});
  }
  nlohmann::json Parsed(const std::string& name) const {
    std::ifstream file(At(name));
    return nlohmann::json::parse(file);
  }
  Finished RunSix(const std::string& faults) const {
    return Run({"--allow-unregistered", "--frames", "6", "--every-frame", "--frame-timeout", "0.5"},
               faults);
  }
};

TEST_F(V4l2Test, TakesDepthAndColorOfTheSameMoment) {
  const Finished finished =
      Run({"--allow-unregistered", "--frames", "4", "--every-frame", "--save", At("out")});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(CountOf(finished.out, "answered"), 4) << finished.out;
  const std::vector<SavedFrame> saved = Saved(At("out"));
  ASSERT_EQ(saved.size(), 4U);
  constexpr std::size_t kBuffers = 4;
  for (std::size_t i = 0; i < saved.size(); ++i) {
    EXPECT_EQ(saved[i].generated, i * (1 + kBuffers) % frames_.size())
        << "depth without loss, and none that the kernel held while a frame was answered";
    const cv::Mat& color = frames_[saved[i].generated].frame.color_rgb;
    EXPECT_LT(cv::norm(saved[i].color, color, cv::NORM_L1) / (3.0 * color.total()), 6);
    double num_objects = 0;
    cv::minMaxLoc(saved[i].labels, nullptr, &num_objects);
    EXPECT_GT(num_objects, 0);
  }
}

TEST_F(V4l2Test, TellsTheServerWhereTheDepthCameraIs) {
  const Finished finished =
      Run({"--frames", "1", "--every-frame", "--save", At("out"), "--depth-intrinsics",
           At("k.json"), "--color-from-depth", "0.015,0,0,0,0,0,1", "--depth-unit", "0.0005"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const std::vector<SavedFrame> saved = Saved(At("out"));
  ASSERT_EQ(saved.size(), 1U);
  EXPECT_THAT(saved.front().json, HasSubstr("\"color_from_depth\":{"));
  EXPECT_THAT(saved.front().json, HasSubstr("\"x\":0.015"));
  EXPECT_THAT(saved.front().json, HasSubstr("0.0005"));
}

// `fovea detect` reads what was saved as it is.
TEST_F(V4l2Test, SavesWhereTheDepthCameraIs) {
  const Finished captured =
      Run({"--frames", "1", "--every-frame", "--save", At("out"), "--color-encoding", "rgb8",
           "--depth-intrinsics", At("k.json"), "--color-from-depth", "0.015,0,0,0,0,0,1",
           "--depth-unit", "0.0005"});
  ASSERT_EQ(captured.exit_code, 0) << captured.err;
  const auto detect = [&](std::vector<std::string> flags) {
    flags.insert(flags.begin(),
                 {FOVEA_CLI, "detect", "--server", server_.address(), "--input", At("out")});
    return Execute(flags);
  };
  const Finished finished = detect({"--output", At("again")});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("note: depth camera from " + At("out/fovea_capture.json")));
  const auto answer = Parsed("out/000001.json"), again = Parsed("again/000001.json");
  EXPECT_EQ(again["frame"], answer["frame"]);
  EXPECT_EQ(again["support_surface"], answer["support_surface"]);
  EXPECT_EQ(again["objects"].size(), answer["objects"].size());

  const Finished otherwise = detect({"--json", "-", "--depth-unit", "0.001", "--depth-intrinsics",
                                     "300,300,160,120", "--color-from-depth", "0,0,0,0,0,0,1"});
  EXPECT_EQ(otherwise.exit_code, 0) << otherwise.err;
  EXPECT_THAT(otherwise.out, HasSubstr(R"("unit_m":0.001)"));
  EXPECT_THAT(otherwise.out, HasSubstr(R"("depth_intrinsics":{"fx":300,)"));
}

TEST_F(V4l2Test, EndsWhereTheServerRefusesTheDepthCamera) {
  const auto run = [&](const std::string& intrinsics, const std::string& pose) {
    return Run({"--depth-intrinsics", intrinsics, "--color-from-depth", pose});
  };
  const Finished odd = run("1,1,1e9,1", "0,0,0,0,0,0,1");
  ExpectOneLineError(odd, "frame.depth_intrinsics");
  EXPECT_EQ(CountOf(odd.out, "failed;"), 1) << odd.out;
  ExpectOneLineError(run(At("k.json"), "0,0,0,0,0,0,2"), "frame.color_from_depth");
}

TEST_F(V4l2Test, EndsWhereTheDepthCameraHasImagesOfAnotherSize) {
  folder_.Write("large.json",
                R"({"fx": 300, "fy": 300, "cx": 640, "cy": 360, "width": 1280, "height": 720})");
  ExpectOneLineError(
      Run({"--depth-intrinsics", At("large.json"), "--color-from-depth", "0,0,0,0,0,0,1"}),
      "--depth-intrinsics: " + At("large.json") + " is for images of 1280x720");
}

TEST_F(V4l2Test, ReadsRowsWithPadding) {
  const Finished finished = Run(
      {"--allow-unregistered", "--frames", "2", "--every-frame", "--save", At("out")}, "padded");
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(Saved(At("out")).size(), 2U);
}

TEST_F(V4l2Test, LeavesOutBrokenImages) {
  const Finished finished = RunSix("broken");
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(CountOf(finished.out, "answered"), 6) << finished.out;
  ExpectOneLineError(RunSix("short"), "no pair of images arrives from " + Device() + " for 0.5 s");
}

TEST_F(V4l2Test, GoesOnWithACameraThatComesBack) {
  const Finished finished = RunSix("gone");
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("video-depth is gone: No such device; waiting"));
  EXPECT_THAT(finished.err, HasSubstr("the camera " + Device() + " is back"));
  EXPECT_EQ(CountOf(finished.out, "answered"), 6) << finished.out;
}

TEST_F(V4l2Test, SaysWhatIsWrongWithTheNodes) {
  ExpectOneLineError(RunSix("no-z16"), "video-depth has no Z16 (depth); it has: YUYV");
  ExpectOneLineError(RunSix("busy"), "video-depth is used by another program: ");
  ExpectOneLineError(Run({"--allow-unregistered", "--depth-resolution", "640x480"}),
                     "video-depth has no 640x480; nearest is 320x240");
  ExpectOneLineError(Run({"--frames", "1"}), "give --depth-intrinsics and --color-from-depth");
}

// Of this machine's kernel itself.
TEST_F(V4l2Test, SaysWhatIsNoVideoNode) {
  const auto run = [&](const std::string& device) {
    return Capture(Live({"--allow-unregistered", "--device", device}));
  };
  ExpectOneLineError(run(Device()), "video-depth is no video device: Inappropriate ioctl");
  ExpectOneLineError(run("v4l2:" + At("none") + "," + At("none")),
                     "cannot be opened: No such file");
  ExpectOneLineError(run("v4l2:/dev/video0"), "is not v4l2:DEPTH,COLOR");
  ExpectOneLineError(Capture(Record(At("a.oni"), {"--device", Device()})),
                     "only what OpenNI2 sees is recorded");
}

TEST_F(V4l2Test, HasFlagsThatOtherCamerasDoNotTake) {
  const std::vector<std::pair<std::string, std::string>> flags{
      {"--depth-resolution", "320x240"},
      {"--depth-unit", "0.001"},
      {"--depth-intrinsics", "1,1,1,1"},
      {"--color-from-depth", "0,0,0,0,0,0,1"}};
  for (const auto& [flag, value] : flags) {
    ExpectOneLineError(Capture(Live({flag, value, "--frames", "1"})),
                       flag + " is for --device v4l2:…; OpenNI2 says this");
  }
  ExpectOneLineError(Run({"--allow-unregistered", "--depth-resolution", "0x0", "--frames", "1"}),
                     "--depth-resolution: \"0x0\" is not WIDTHxHEIGHT");
}

}  // namespace
}  // namespace fovea::testing
