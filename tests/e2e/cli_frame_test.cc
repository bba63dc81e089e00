// One frame, and what can be written about it.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "tests/e2e/cli_fixture.h"
#include "tests/support/random_scene.h"
#include "tests/support/scene_files.h"

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(CliTest, PrintsLimitsAndStatistics) {
  const Finished info = Execute({FOVEA_CLI, "info", "--server", server_.address()});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("\"max_pixels\": \"3145728\""));
  EXPECT_THAT(info.out, HasSubstr("\"uptime\": "));
}

TEST_F(CliTest, WritesEveryOutputOfAFrame) {
  const Finished finished =
      DetectFrame({"--labels", At("l.png"), "--json", At("j.json"), "--overlay", At("o.png"),
                   "--cloud", At("c.ply"), "--gravity", "0,1,0"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, StartsWith("a: "));
  EXPECT_THAT(finished.out, HasSubstr("gravity (0.000, 1.000, 0.000), as given"));

  const cv::Mat labels = cv::imread(At("l.png"), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(labels.size(), cv::Size(kWidth, kHeight));
  EXPECT_EQ(labels.channels(), 1);
  EXPECT_EQ(cv::imread(At("o.png")).size(), cv::Size(2 * kWidth, 2 * kHeight));
  const auto num_points = static_cast<std::size_t>(cv::countNonZero(TestDepth()));
  std::ifstream ply(At("c.ply"), std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(ply), {}};
  EXPECT_THAT(bytes, StartsWith("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_THAT(bytes, HasSubstr("element vertex " + std::to_string(num_points) + "\n"));
  EXPECT_EQ(bytes.size() - bytes.find("end_header\n") - 11, num_points * 15);
}

TEST_F(CliTest, SaysThatAFileMayNotGrow) {
  const Finished finished =
      Execute({"/bin/sh", "-c", "ulimit -f 1; exec \"$0\" \"$@\"", FOVEA_CLI, "detect", "--server",
               server_.address(), "--intrinsics", "30,30,15.5,11.5", "--color", At("a_color.png"),
               "--depth", At("a_depth.png"), "--json", At("j.json")});
  ExpectOneLineError(finished, "cannot write " + At("j.json") + ": File too large");
  EXPECT_FALSE(std::filesystem::exists(At("j.json"))) << "half of it";
}

// Whose links lead to no file where it is a pipe.
TEST_F(CliTest, WritesToStandardOutputByItsPath) {
  const Finished finished = DetectFrame({"--json", "/dev/stdout"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("\"objects\": []"));
}

TEST_F(CliTest, ExplainsEveryStep) {
  const cv::Size frame(kWidth, kHeight);
  for (const std::string profile : {"default", "paper"}) {
    const fs::path steps = fs::path(At("steps")) / profile;
    const Finished finished =
        DetectFrame({"--explain", steps.string(), "--profile", profile, "--labels", At("l.png")});
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
    for (const char* name :
         {"01_color", "02_depth", "03_depth_filled", "04_color_saliency", "05_depth_saliency",
          "06_seeds", "08_hypothesis_labels", "09_segments", "10_merged"}) {
      EXPECT_EQ(cv::imread((steps / (std::string(name) + ".png")).string()).size(), frame) << name;
    }
    EXPECT_FALSE(cv::imread((steps / "07_hypotheses.png").string()).empty());
    EXPECT_FALSE(cv::imread((steps / "11_objects.png").string()).empty());
    EXPECT_GT(fs::file_size(steps / "12_cloud.ply"), 15U * kWidth);
    std::ifstream page(steps / "index.html");
    const std::string html{std::istreambuf_iterator<char>(page), {}};
    EXPECT_THAT(html, HasSubstr("profile " + profile));
    EXPECT_THAT(html, HasSubstr("src=\"11_objects.png\""));
    // Black is where nothing was measured.
    const cv::Mat depth = cv::imread((steps / "02_depth.png").string(), cv::IMREAD_GRAYSCALE);
    EXPECT_EQ(cv::countNonZero((depth == 0) != (TestDepth() == 0)), 0);
  }
  Write("taken", "");
  ExpectOneLineError(DetectFrame({"--explain", At("taken")}), "--explain: cannot write");
  ExpectOneLineError(Detect({"--input", At(""), "--output", At("o"), "--explain", At("s")}),
                     "a single frame");
}

TEST_F(CliTest, ExplainsWhatItDoesNotReport) {
  const cv::Size size(320, 240);
  scenes::WriteFrame(Folder(), "s",
                     scenes::MakeFrame(scenes::RandomScene("tabletop", /*seed=*/1, size),
                                       scenes::SensorKind::kKinect, /*seed=*/1));
  const fs::path steps = At("steps");
  const Finished finished = Execute({FOVEA_CLI, "detect", "--server", server_.address(),
                                     "--intrinsics", "262.5,262.5,159.5,119.5", "--color",
                                     At("s_color.png"), "--depth", At("s_depth.png"), "--explain",
                                     steps.string(), "--set", "objects.min_probability=1"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(cv::imread((steps / "13_rejected.png").string()).size(), size);
  std::ifstream file(steps / "index.html");
  const std::string html{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(html, HasSubstr("src=\"13_rejected.png\""));
  EXPECT_THAT(html, HasSubstr("against it: "));
}

TEST_F(CliTest, SendsJpegAsItIs) {
  Write("a.jpg", JpegOf(TestColor()));
  const Finished finished = Detect({"--color", At("a.jpg"), "--depth", At("a_depth.png")});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
}

TEST_F(CliTest, SendsDepthThatIsNotRegistered) {
  const std::vector<std::string> beside = {"--depth-intrinsics", "30,30,15.5,11.5",
                                           "--color-from-depth", "-0.02,0,0,0,0,0,1"};
  std::vector<std::string> flags = beside;
  flags.insert(flags.end(), {"--labels", At("l.png"), "--cloud", At("c.ply")});
  const Finished finished = DetectFrame(flags);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(cv::imread(At("l.png"), cv::IMREAD_UNCHANGED).size(), cv::Size(kWidth, kHeight));
  EXPECT_GT(fs::file_size(At("c.ply")), 15U * kWidth);

  const Finished away = DetectFrame({beside[0], beside[1], beside[2], "0,0,0,0,1,0,0"});
  EXPECT_THAT(away.out, HasSubstr("depth registered by color_from_depth covers 0 pixels"));
  ExpectOneLineError(DetectFrame({beside[0], beside[1]}),
                     "--depth-intrinsics needs --color-from-depth");
  ExpectOneLineError(DetectFrame({beside[2], beside[3]}),
                     "--color-from-depth needs --depth-intrinsics");
  ExpectOneLineError(DetectFrame({beside[0], "30,30", beside[2], beside[3]}),
                     "--depth-intrinsics: \"30,30\" is not FX,FY,CX,CY");
  Write("large.json", R"({"fx": 30, "fy": 30, "cx": 15, "cy": 11, "width": 64, "height": 48})");
  ExpectOneLineError(
      DetectFrame({"--depth-intrinsics", At("large.json"), "--color-from-depth", "0,0,0,0,0,0,1"}),
      "--depth-intrinsics: " + At("large.json") + " is for images of 64x48, this one has 32x24");
  ExpectOneLineError(DetectFrame({beside[0], beside[1], beside[2], "0,0,0"}),
                     "--color-from-depth: \"0,0,0\" is not X,Y,Z,QX,QY,QZ,QW");
  ExpectOneLineError(DetectFrame({beside[0], beside[1], beside[2], "0,0,0,0,0,0,2"}),
                     "INVALID_ARGUMENT: frame.color_from_depth.orientation: ");
}

}  // namespace
}  // namespace fovea::testing
