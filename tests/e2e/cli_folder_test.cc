// Folders of frames, and bags.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "tests/e2e/cli_fixture.h"
#include "tests/support/bag_writer.h"

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST_F(CliTest, RunsOverAFolderAndGoesOnAfterAFrameThatFailed) {
  for (const char* name : {"b", "c", "d"}) WriteFrame(name);
  fs::remove(At("b_depth.png"));
  Write("c_depth.png", PngOf(TestColor()));
  Write("notes.txt", "not a frame");
  const Finished finished = Detect({"--input", Folder(), "--output", At("out")});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_THAT(finished.out, HasSubstr("2 of 4 frames done"));
  EXPECT_THAT(finished.out, HasSubstr("2 failed"));
  EXPECT_LT(finished.out.find("1/4  a"), finished.out.find("4/4  d"));
  EXPECT_THAT(finished.err, HasSubstr("fovea: b: no " + At("b_depth.png")));
  EXPECT_THAT(finished.err, HasSubstr("fovea: c: INVALID_ARGUMENT: frame.depth.data: "));
  for (const char* file : {"a.png", "a.json", "a_overlay.jpg", "d.png"}) {
    EXPECT_TRUE(fs::exists(fs::path(At("out")) / file)) << file;
  }
  EXPECT_FALSE(fs::exists(fs::path(At("out")) / "b.png"));
}

TEST_F(CliTest, SaysThatAFrameWithoutDepthCountsAsFailed) {
  WriteFrame("b");
  fs::remove(At("b_depth.png"));
  const Finished finished = Detect({"--input", Folder(), "--output", At("out")});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_THAT(finished.err, HasSubstr("fovea: b: no " + At("b_depth.png") + ", counts as failed"));
  EXPECT_THAT(finished.out, HasSubstr("1 of 2 frames done"));
}

// What a server refuses counts there, and is sent once more.
TEST_F(CliTest, SendsNoMoreFramesAtOnceThanTheServerTakes) {
  for (const char* name : {"b", "c", "d", "e", "f", "g", "h"}) WriteFrame(name);
  const ServerProcess narrow({"--compute-threads", "1", "--max-per-robot", "1"});
  const Finished finished =
      Execute({FOVEA_CLI, "detect", "--server", narrow.address(), "--intrinsics", "30,30,15.5,11.5",
               "--input", Folder(), "--json", "-", "--no-masks"});
  EXPECT_THAT(finished.err, HasSubstr("8 of 8 frames done"));
  const Finished info = Execute({FOVEA_CLI, "info", "--server", narrow.address()});
  EXPECT_EQ(nlohmann::json::parse(info.out).at("statistics").at("frames_answered"),
            nlohmann::json({{"OK", "8"}}));
}

TEST_F(CliTest, ReadsNoPipesAndDevicesOfFolders) {
  fs::remove(At("a_color.png"));
  ASSERT_EQ(mkfifo(At("a_color.png").c_str(), S_IRUSR | S_IWUSR), 0);
  fs::create_symlink("/dev/zero", At("b_color.png"));
  fs::copy(At("a_depth.png"), At("b_depth.png"));
  const Finished finished = Detect({"--input", Folder(), "--output", At("out")});
  EXPECT_THAT(finished.err, HasSubstr("fovea: a: " + At("a_color.png") + " is no regular file"));
  EXPECT_THAT(finished.err, HasSubstr("fovea: b: " + At("b_color.png") + " is no regular file"));
}

// Which a few bytes of an archive can become.
TEST_F(CliTest, ReadsNoFilesThatAreTooLarge) {
  fs::resize_file(At("a_depth.png"), std::uintmax_t{1} << 34);
  const Finished finished = Detect({"--input", Folder(), "--output", At("out")});
  EXPECT_THAT(finished.err, HasSubstr("fovea: a: " + At("a_depth.png") + " has more than 1 GiB"));
}

TEST_F(CliTest, GoesOnWithAFolderWhereItStopped) {
  for (const char* name : {"b", "c"}) WriteFrame(name);
  const std::vector<std::string> flags{"--input", Folder(),       "--output", At("out"), "--jobs",
                                       "3",       "--no-overlay", "--cloud",  "pcd"};
  EXPECT_THAT(Detect(flags).out, HasSubstr("3 of 3 frames done"));
  EXPECT_FALSE(fs::exists(At("out/a_overlay.jpg")));
  EXPECT_GT(fs::file_size(At("out/a.pcd")), 16U * kWidth);
  fs::remove(At("out/b.json"));
  Write("out/c.json", "kept");
  std::vector<std::string> again = flags;
  again.emplace_back("--resume");
  EXPECT_THAT(Detect(again).out, HasSubstr("1 of 1 frames done, 0 objects, 0 failed; 2 were done"));
  EXPECT_TRUE(fs::exists(At("out/b.json")));
  EXPECT_EQ(fs::file_size(At("out/c.json")), 4U);
  again.insert(again.end(), {"--gripper", "none"});
  ExpectOneLineError(Detect(again), "--resume: the results in " + At("out"));
}

TEST_F(CliTest, LeavesNoAnswerOfARunBeforeBesideNewFiles) {
  const std::vector<std::string> flags{"--input", Folder(), "--output", At("out")};
  EXPECT_EQ(Detect(flags).exit_code, 0);
  fs::remove(At("out/a_overlay.jpg"));
  fs::create_directory(At("out/a_overlay.jpg"));
  const Finished again = Detect(flags);
  EXPECT_THAT(again.err, HasSubstr("cannot write " + At("out/a_overlay.jpg")));
  EXPECT_TRUE(fs::exists(At("out/a.png")));
  EXPECT_FALSE(fs::exists(At("out/a.json")));
}

TEST_F(CliTest, EndsWhereNobodyCanBeGivenLinesOfJson) {
  for (const char* name : {"b", "c"}) WriteFrame(name);
  const Finished finished = Execute({"sh", "-c", "exec \"$@\" > /dev/full", "sh", FOVEA_CLI,
                                     "detect", "--server", server_.address(), "--intrinsics",
                                     "30,30,15.5,11.5", "--input", Folder(), "--json", "-"});
  ExpectOneLineError(finished, "standard output cannot be written");
}

TEST_F(CliTest, PrintsAnswersAsLinesOfJson) {
  for (const char* name : {"b", "c", "d", "e"}) WriteFrame(name);
  const Finished many = Detect({"--input", Folder(), "--json", "-", "--jobs", "4", "--no-masks"});
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
  Write("k.json", R"({"fx": 30, "fy": 30, "cx": 15.5, "cy": 11.5, "width": 32, "height": 24})");
  const auto detect = [&](const std::string& intrinsics) {
    return Execute({FOVEA_CLI, "detect", "--server", server_.address(), "--intrinsics", intrinsics,
                    "--color", At("a_color.png"), "--depth", At("a_depth.png")});
  };
  EXPECT_EQ(detect("30, 30, 15.5, 11.5").exit_code, 0);
  EXPECT_EQ(detect(At("k.json")).exit_code, 0);
  Write("k.json", R"({"fx": 30, "fy": 30, "cx": 15.5, "cy": 11.5, "width": 64, "height": 48})");
  ExpectOneLineError(detect(At("k.json")),
                     At("k.json") + " is for images of 64x48, this one has 32x24");

  Write("k.json", R"({"width": 32, "height": 24, "k": [30, 0, 15.5, 0, 30, 11.5, 0, 0, 1],
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
  const std::vector<std::string> folder{FOVEA_CLI, "detect", "--server", server_.address(),
                                        "--input", Folder(), "--output", At("out")};
  ExpectOneLineError(Execute(folder), "--intrinsics is required");
  Write("intrinsics.txt", "30,30,15.5,11.5\n");
  const Finished finished = Execute(folder);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("note: intrinsics from " + At("intrinsics.txt")));
}

TEST_F(CliTest, NotesFramesOfOtherSizesWhereIntrinsicsAreOfNone) {
  for (const char* name : {"b", "c"}) {
    cv::Mat color, depth;
    cv::resize(TestColor(), color, {}, 0.5, 0.5, cv::INTER_NEAREST);
    cv::resize(TestDepth(), depth, {}, 0.5, 0.5, cv::INTER_NEAREST);
    Write(std::string(name) + "_color.png", PngOf(color));
    Write(std::string(name) + "_depth.png", PngOf(depth));
  }
  const Finished finished = Detect({"--input", Folder(), "--output", At("out")});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.err,
            "note: b has 16x12, frames before it 32x24: --intrinsics without a size are used for "
            "all, and are those of one\n");
}

TEST_F(CliTest, ReadsTumFolders) {
  fs::create_directory(At("tum"));
  Write("tum/rgb.txt", "# time path\n1305031102.175304 ../a_color.png\n");
  Write("tum/depth.txt", "1305031102.160407 ../a_depth.png\n1305031109.1 none.png\n");
  const Finished finished = Detect({"--input", At("tum"), "--json", "-"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const auto answer = nlohmann::json::parse(finished.out);
  EXPECT_EQ(answer["captured_at"], "2011-05-10T12:38:22.175304Z");
  EXPECT_EQ(answer["frame"]["depth"]["unit_m"], 0.0002);
  EXPECT_THAT(finished.err, HasSubstr("note: 1 depth images without colour within 20 ms"));
}

TEST_F(CliTest, WritesNothingIntoTheFolderOfTheFrames) {
  Write("a.json", "the truth");
  const Finished finished = Detect({"--input", At(""), "--output", Folder()});
  ExpectOneLineError(finished, "--output: " + Folder() + " is a folder of --input");
  EXPECT_EQ(fs::file_size(At("a.json")), 9U);

  for (const char* images : {"rgb", "depth"})
    fs::create_directories(At(std::string("seq/") + images));
  fs::copy(At("a_color.png"), At("seq/rgb/1.png"));
  fs::copy(At("a_depth.png"), At("seq/depth/1.png"));
  const auto size = fs::file_size(At("seq/depth/1.png"));
  ExpectOneLineError(Detect({"--input", At("seq"), "--output", At("seq/depth")}),
                     "--output: " + At("seq/depth") + " is a folder of --input");
  EXPECT_EQ(fs::file_size(At("seq/depth/1.png")), size);
}

// With a frame for each camera_info, of which the first holds.
std::string BagOf(const std::vector<std::string>& infos) {
  const auto data = [](const cv::Mat& image) {
    return std::string(reinterpret_cast<const char*>(image.data), image.total() * image.elemSize());
  };
  std::int64_t time_ns = 1'700'000'000'500'000'000;
  BagWriter writer;
  for (const std::string& info : infos) {
    writer.Add("/color/camera_info", "CameraInfo", info);
    writer.Add("/color/\x1bimage", "Image",  // no topic of ROS, but bags may be of anybody
               ImageMessage(time_ns, "rgb8", kWidth, kHeight, 3 * kWidth, data(TestColor())));
    writer.Add("/depth/image", "Image",
               ImageMessage(time_ns, "16UC1", kWidth, kHeight, 2 * kWidth, data(TestDepth())));
    time_ns += 1'000'000'000;
  }
  writer.EndChunk("lz4");
  return writer.Finish();
}

TEST_F(CliTest, ReadsBags) {
  Write("b.mcap", BagOf({CameraInfoMessage(kWidth, kHeight, 30, -0.1)}));
  const auto detect = [&](std::vector<std::string> flags) {
    flags.insert(flags.begin(), {FOVEA_CLI, "detect", "--server", server_.address(), "--input",
                                 At("b.mcap"), "--output", At("out")});
    return Execute(flags);
  };
  const Finished finished = detect({});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("note: colour of /color/\\x1bimage, depth of /depth/image"));
  EXPECT_THAT(finished.err, HasSubstr("note: intrinsics from /color/camera_info of"));
  std::ifstream file(At("out/1700000000.500000000.json"));
  const auto json = nlohmann::json::parse(file);
  EXPECT_EQ(json["frame"]["intrinsics"]["distortion"]["coefficients"][0], -0.1);
  EXPECT_TRUE(fs::exists(At("out/1700000000.500000000_overlay.jpg")));

  ExpectOneLineError(detect({"--depth-topic", "/d"}),
                     "b.mcap: --depth-topic: it has no images of /d");
  Write("b.mcap", "no bag");
  ExpectOneLineError(detect({}), "b.mcap: it is no MCAP file");
}

TEST_F(CliTest, EndsABagWhoseCameraInfoIsOfAnotherSize) {
  const std::string larger = CameraInfoMessage(2 * kWidth, 2 * kHeight, 60);
  Write("b.mcap", BagOf({larger, larger, larger}));
  const Finished finished = Execute({FOVEA_CLI, "detect", "--server", server_.address(), "--input",
                                     At("b.mcap"), "--output", At("out")});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_THAT(finished.err,
              EndsWith("\nfovea: /color/camera_info: it is for images of 64x48, colour "
                       "has 32x24; give --intrinsics instead\n"));
  EXPECT_THAT(finished.out, Not(HasSubstr("failed")));
  EXPECT_EQ(Detect({"--input", At("b.mcap"), "--output", At("out")}).exit_code, 0);
}

}  // namespace
}  // namespace fovea::testing
