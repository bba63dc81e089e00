// The command-line client on files, against the real server.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "tests/e2e/server_process.h"
#include "tests/server/frames.h"
#include "tests/support/random_scene.h"
#include "tests/support/scene_files.h"

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

void Write(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

class CliTest : public ::testing::Test {
 protected:
  CliTest() {
    std::string pattern = (fs::temp_directory_path() / "fovea_cli_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    WriteFrame("a");
  }
  ~CliTest() override { fs::remove_all(folder_); }

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
    EXPECT_THAT(finished.err, StartsWith("fovea: "));
    EXPECT_THAT(finished.err, HasSubstr(text));
    EXPECT_EQ(std::count(finished.err.begin(), finished.err.end(), '\n'), 1) << finished.err;
  }

  ServerProcess server_;
  fs::path folder_;
};

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

TEST_F(CliTest, ExplainsEveryStep) {
  const cv::Size frame(kWidth, kHeight);
  for (const std::string profile : {"default", "paper"}) {
    const fs::path steps = folder_ / "steps" / profile;
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
  Write(At("taken"), "");
  ExpectOneLineError(DetectFrame({"--explain", At("taken")}), "--explain: cannot write");
  ExpectOneLineError(Detect({"--input", At(""), "--output", At("o"), "--explain", At("s")}),
                     "a single frame");
}

TEST_F(CliTest, ExplainsWhatItDoesNotReport) {
  const cv::Size size(320, 240);
  scenes::WriteFrame(folder_, "s",
                     scenes::MakeFrame(scenes::RandomScene("tabletop", /*seed=*/1, size),
                                       scenes::SensorKind::kKinect, /*seed=*/1));
  const fs::path steps = folder_ / "steps";
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
  Write(At("a.jpg"), JpegOf(TestColor()));
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
  ExpectOneLineError(DetectFrame({beside[0], beside[1], beside[2], "0,0,0"}),
                     "--color-from-depth: \"0,0,0\" is not X,Y,Z,QX,QY,QZ,QW");
  ExpectOneLineError(DetectFrame({beside[0], beside[1], beside[2], "0,0,0,0,0,0,2"}),
                     "INVALID_ARGUMENT: frame.color_from_depth.orientation: ");
}

TEST_F(CliTest, RunsOverAFolderAndGoesOnAfterAFrameThatFailed) {
  for (const char* name : {"b", "c", "d"}) WriteFrame(name);
  fs::remove(At("b_depth.png"));
  Write(At("c_depth.png"), PngOf(TestColor()));
  Write(At("notes.txt"), "not a frame");
  const Finished finished = Detect({"--input", folder_.string(), "--output", At("out")});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_THAT(finished.out, HasSubstr("2 of 4 frames done"));
  EXPECT_THAT(finished.out, HasSubstr("2 failed"));
  EXPECT_LT(finished.out.find("1/4  a"), finished.out.find("4/4  d"));
  EXPECT_THAT(finished.err, HasSubstr("fovea: b: no " + At("b_depth.png")));
  EXPECT_THAT(finished.err, HasSubstr("fovea: c: INVALID_ARGUMENT: frame.depth.data: "));
  for (const char* file : {"a.png", "a.json", "a_overlay.jpg", "d.png"}) {
    EXPECT_TRUE(fs::exists(folder_ / "out" / file)) << file;
  }
  EXPECT_FALSE(fs::exists(folder_ / "out" / "b.png"));
}

TEST_F(CliTest, GoesOnWithAFolderWhereItStopped) {
  for (const char* name : {"b", "c"}) WriteFrame(name);
  const std::vector<std::string> flags{"--input", folder_.string(), "--output", At("out"), "--jobs",
                                       "3",       "--no-overlay",   "--cloud",  "pcd"};
  EXPECT_THAT(Detect(flags).out, HasSubstr("3 of 3 frames done"));
  EXPECT_FALSE(fs::exists(At("out/a_overlay.jpg")));
  EXPECT_GT(fs::file_size(At("out/a.pcd")), 16U * kWidth);
  fs::remove(At("out/b.json"));
  Write(At("out/c.json"), "kept");
  std::vector<std::string> again = flags;
  again.emplace_back("--resume");
  EXPECT_THAT(Detect(again).out, HasSubstr("1 of 1 frames done, 0 objects, 0 failed; 2 were done"));
  EXPECT_TRUE(fs::exists(At("out/b.json")));
  EXPECT_EQ(fs::file_size(At("out/c.json")), 4U);
  again.insert(again.end(), {"--gripper", "none"});
  ExpectOneLineError(Detect(again), "--resume: the results in " + At("out"));
}

TEST_F(CliTest, PrintsAnswersAsLinesOfJson) {
  for (const char* name : {"b", "c", "d", "e"}) WriteFrame(name);
  const Finished many =
      Detect({"--input", folder_.string(), "--json", "-", "--jobs", "4", "--no-masks"});
  EXPECT_EQ(many.exit_code, 0) << many.err;
  EXPECT_THAT(many.err, HasSubstr("5 of 5 frames done"));
  std::istringstream lines(many.out);
  std::string line;
  for (const std::string name : {"a", "b", "c", "d", "e"}) {
    ASSERT_TRUE(std::getline(lines, line));
    const auto answer = nlohmann::json::parse(line);
    EXPECT_EQ(answer["frame_id"], name);
    EXPECT_EQ(answer["frame"]["intrinsics"]["fx"], 30);
  }
  EXPECT_FALSE(std::getline(lines, line));

  const Finished one = DetectFrame({"--json", "-"});
  EXPECT_EQ(nlohmann::json::parse(one.out)["frame_id"], "a");
  EXPECT_THAT(one.err, StartsWith("a: 0 objects"));
}

TEST_F(CliTest, TakesIntrinsicsFromFiles) {
  Write(At("k.json"), R"({"fx": 30, "fy": 30, "cx": 15.5, "cy": 11.5, "width": 32, "height": 24})");
  const auto detect = [&](const std::string& intrinsics) {
    return Execute({FOVEA_CLI, "detect", "--server", server_.address(), "--intrinsics", intrinsics,
                    "--color", At("a_color.png"), "--depth", At("a_depth.png")});
  };
  EXPECT_EQ(detect(At("k.json")).exit_code, 0);
  Write(At("k.json"), R"({"fx": 30, "fy": 30, "cx": 15.5, "cy": 11.5, "width": 64, "height": 48})");
  ExpectOneLineError(detect(At("k.json")),
                     At("k.json") + " is for images of 64x48, this one has 32x24");

  Write(At("k.json"), R"({"width": 32, "height": 24, "k": [30, 0, 15.5, 0, 30, 11.5, 0, 0, 1],
                          "distortion_model": "plumb_bob", "d": [-0.1, 0.01, 0, 0, 0]})");
  const Finished bent = detect(At("k.json"));
  EXPECT_EQ(bent.exit_code, 0) << bent.err;
  EXPECT_THAT(bent.err, HasSubstr("note: lens distortion from " + At("k.json")));
  // It is the server that looks at what was sent.
  const auto with = [&](const std::string& distortion) {
    return DetectFrame({"--distortion", distortion, "--overlay", At("o.png"), "--json", "-"});
  };
  EXPECT_THAT(with("plumb_bob=-0.1,0.01,0,0").out, HasSubstr("\"distortion\":{\"model\":"));
  EXPECT_THAT(with("none").out, Not(HasSubstr("distortion")));
  ExpectOneLineError(with("plumb_bob=-5,0,0,0"),
                     "INVALID_ARGUMENT: frame.intrinsics.distortion.coefficients: ");
  ExpectOneLineError(with("plumb_bob"), "--distortion: \"plumb_bob\" is not MODEL=K1,K2,");

  // Of a folder without --intrinsics the one that lies there.
  const std::vector<std::string> folder{FOVEA_CLI, "detect",         "--server", server_.address(),
                                        "--input", folder_.string(), "--output", At("out")};
  ExpectOneLineError(Execute(folder), "--intrinsics is required");
  Write(At("intrinsics.txt"), "30,30,15.5,11.5\n");
  const Finished finished = Execute(folder);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("note: intrinsics from " + At("intrinsics.txt")));
}

TEST_F(CliTest, ReadsTumFolders) {
  fs::create_directory(At("tum"));
  Write(At("tum/rgb.txt"), "# time path\n1305031102.175304 ../a_color.png\n");
  Write(At("tum/depth.txt"), "1305031102.160407 ../a_depth.png\n1305031109.1 none.png\n");
  const Finished finished = Detect({"--input", At("tum"), "--json", "-"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const auto answer = nlohmann::json::parse(finished.out);
  EXPECT_EQ(answer["captured_at"], "2011-05-10T12:38:22.175304Z");
  EXPECT_EQ(answer["frame"]["depth"]["unit_m"], 0.0002);
  EXPECT_THAT(finished.err, HasSubstr("note: 1 depth images without colour within 20 ms"));
}

TEST_F(CliTest, WritesNothingIntoTheFolderOfTheFrames) {
  Write(At("a.json"), "the truth");
  const Finished finished = Detect({"--input", At(""), "--output", folder_.string()});
  ExpectOneLineError(finished, "--output: " + folder_.string() + " is the folder of --input");
  EXPECT_EQ(fs::file_size(At("a.json")), 9U);
}

TEST_F(CliTest, ChecksOutputsBeforeItAsksTheServer) {
  server_.process().Signal(SIGTERM);
  server_.process().Wait();
  const std::string bad = At("no/l.png");
  ExpectOneLineError(DetectFrame({"--json", At("j.json"), "--labels", bad}),
                     "--labels: cannot write " + bad + ": there is no folder " + At("no"));
  ExpectOneLineError(DetectFrame({"--overlay", At("a_color.png")}), "is an image of the frame");
  ExpectOneLineError(DetectFrame({"--labels", At("l.jpg")}), "labels need a format without loss");
  ExpectOneLineError(DetectFrame({"--cloud", At("c.stl")}), "--cloud: \"stl\" is not a kind");
  ExpectOneLineError(Detect({"--input", folder_.string(), "--output", At("a_depth.png")}),
                     "--output: cannot write " + At("a_depth.png"));
}

// Of a plane that fills the picture no level surface and no object can be made out.
TEST_F(CliTest, SaysWhyAFrameHasNoObjects) {
  const Finished one = DetectFrame();
  EXPECT_THAT(one.out, StartsWith("a: 0 objects in"));
  EXPECT_THAT(one.out, HasSubstr("\nnote: "));
  const Finished many = Detect({"--input", folder_.string(), "--output", At("out")});
  EXPECT_THAT(many.out, StartsWith("1/1  a: 0 objects\n  note: "));
}

TEST_F(CliTest, SaysInOneLineWhatIsWrong) {
  ExpectOneLineError(DetectFrame({"--bogus"}), "--bogus");
  ExpectOneLineError(DetectFrame({"--overlai", At("o.png")}), "did you mean --overlay?");
  ExpectOneLineError(Execute({FOVEA_CLI, "detct"}), "did you mean detect?");
  ExpectOneLineError(DetectFrame({"--gripper", "claw=1"}), "--gripper: \"claw=1\" is not jaw=");
  ExpectOneLineError(DetectFrame({"--place", "1,2"}), "--place: \"1,2\" is not LENGTH");
  ExpectOneLineError(DetectFrame({"--gravity", "1,2"}), "--gravity: \"1,2\" is not X,Y,Z");
  ExpectOneLineError(DetectFrame({"--gravity", "0,2,0"}), "INVALID_ARGUMENT: frame.gravity: ");
  ExpectOneLineError(DetectFrame({"--set", "x"}), "--set: \"x\" is not NAME=NUMBER");
  ExpectOneLineError(DetectFrame({"--set", "no.such=1"}), "options.parameters[no.such]: ");
  ExpectOneLineError(DetectFrame({"--profile", "fast"}), "options.profile: ");
  ExpectOneLineError(DetectFrame({"--depth-unit", "0"}), "--depth-unit: 0 is not above 0");
  ExpectOneLineError(Execute({FOVEA_CLI, "health", "--server", "localhost"}),
                     "--server: \"localhost\" is not HOST:PORT");
  ExpectOneLineError(DetectFrame({"--tls-ca", At("a_color.png")}),
                     "--tls-ca: " + At("a_color.png") + " holds no CERTIFICATE in PEM");
  ExpectOneLineError(DetectFrame({"--input", folder_.string()}), "--output");
  ExpectOneLineError(Detect({}), "--color");
  ExpectOneLineError(Execute({FOVEA_CLI, "detect", "--colour", "c.png"}), "--colour");
  ExpectOneLineError(Execute({FOVEA_CLI, "detect", "--color", "c.png"}), "--intrinsics");
  ExpectOneLineError(Detect({"--color", At("none.png"), "--depth", At("a_depth.png")}),
                     "cannot read " + At("none.png"));
  ExpectOneLineError(Detect({"--color", folder_.string(), "--depth", At("a_depth.png")}),
                     "is a folder");
  ExpectOneLineError(Detect({"--input", At("none"), "--output", At("out")}), "cannot read");
  fs::create_directory(At("empty"));
  ExpectOneLineError(Detect({"--input", At("empty"), "--output", At("out")}), "no NAME_color.png");
}

TEST_F(CliTest, AsksForHealth) {
  const Finished healthy = Execute({FOVEA_CLI, "health", "--server", server_.address()});
  EXPECT_EQ(healthy.exit_code, 0);
  EXPECT_EQ(healthy.out, server_.address() + " is serving\n");

  const std::string text = "no server answers at " + server_.address();
  server_.process().Signal(SIGTERM);
  server_.process().Wait();
  ExpectOneLineError(Execute({FOVEA_CLI, "health", "--server", server_.address()}), text);
  ExpectOneLineError(DetectFrame(), text);
  const Finished folder = Detect({"--input", folder_.string(), "--output", At("out")});
  EXPECT_EQ(folder.exit_code, 1);
  EXPECT_THAT(folder.err, StartsWith("fovea: a: " + text));
}

}  // namespace
}  // namespace fovea::testing
