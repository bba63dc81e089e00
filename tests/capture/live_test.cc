// A camera, a server and what comes back.
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "tests/capture/capture_process.h"

namespace fovea::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// The largest intersection over union of this object's pixels with any label, among pixels with
// depth.
double BestIou(const cv::Mat& truth, const cv::Mat& labels) {
  double best = 0, num_labels = 0;
  cv::minMaxLoc(labels, nullptr, &num_labels);
  for (int label = 1; label <= num_labels; ++label) {
    const cv::Mat found = labels == label;
    best = std::max(best, static_cast<double>(cv::countNonZero(truth & found)) /
                              cv::countNonZero(truth | found));
  }
  return best;
}

// The mean of it over the objects of a generated frame.
double MeanIou(const scenes::LabelledFrame& truth, const cv::Mat& labels) {
  const cv::Mat measured = truth.frame.depth_m == truth.frame.depth_m;  // not NaN
  double sum = 0;
  for (const scenes::ObjectTruth& object : truth.objects) {
    sum += BestIou((truth.labels == object.label) & measured, labels);
  }
  return sum / static_cast<double>(truth.objects.size());
}

// Each frame that was sent is answered, dropped or lost.
void ExpectAllAccountedFor(const std::string& out) {
  EXPECT_EQ(CountOf(out, "sent"), CountOf(out, "answered") + CountOf(out, "failed") +
                                      CountOf(out, "by the server") + CountOf(out, "lost\n"))
      << out;
  EXPECT_EQ(CountOf(out, "frames captured"), CountOf(out, "sent") + CountOf(out, "by this client"))
      << out;
}

TEST_F(CaptureTest, ListsDevicesWithTheirModes) {
  const Finished finished = Capture({"devices"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, "fovea/test@0/1  Fovea, Test camera  320x240 at 15, 320x240 at 30\n");
}

TEST_F(CaptureTest, FindsTheObjectsOfTheScene) {
  const Finished finished =
      Capture(Live({"--frames", "10", "--save", At("out")}), {{"FOVEA_CAMERA_FPS", "30"}});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(CountOf(finished.out, "frames captured"), 10) << finished.out;
  ExpectAllAccountedFor(finished.out);
  EXPECT_THAT(finished.out, HasSubstr("latency from frame to result: median "));
  const std::vector<SavedFrame> saved = Saved(At("out"));
  EXPECT_EQ(static_cast<int>(saved.size()), CountOf(finished.out, "answered"));
  for (const SavedFrame& frame : saved) {
    const double iou = MeanIou(frames_[frame.generated], frame.labels);
    const double other = MeanIou(frames_[(frame.generated + 1) % frames_.size()], frame.labels);
    EXPECT_GT(iou, 0.6) << frame.name;
    EXPECT_LT(other, 0.3) << "the measure tells scenes apart";
    EXPECT_EQ(cv::norm(frame.color, frames_[frame.generated].frame.color_rgb, cv::NORM_INF), 0);
  }
}

TEST_F(CaptureTest, TakesEveryFrameWhenTold) {
  const Finished finished = Capture(Live({"--every-frame", "--frames", "7", "--save", At("out")}));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(CountOf(finished.out, "answered"), 7);
  EXPECT_EQ(CountOf(finished.out, "by the camera"), 0);
  std::vector<std::size_t> generated;
  for (const SavedFrame& frame : Saved(At("out"))) generated.push_back(frame.generated);
  EXPECT_THAT(generated, ElementsAre(0, 1, 2, 0, 1, 2, 0));
}

TEST_F(CaptureTest, AsksForTracksHandsAndPlaces) {
  const Finished finished =
      Capture(Live({"--frames", "3", "--save", At("out"), "--track", "--gripper", "suction=0.03",
                    "--place", "0.05,0.05,0.05", "--max-places", "1"}));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const std::vector<SavedFrame> saved = Saved(At("out"));
  ASSERT_FALSE(saved.empty());
  for (const SavedFrame& frame : saved) {
    EXPECT_THAT(frame.json, Not(HasSubstr("\"track_epoch\":\"0\"")));
    EXPECT_THAT(frame.json, HasSubstr("\"gripper\":\"suction=0.03\""));
    EXPECT_THAT(frame.json, HasSubstr("\"free_places\":[{"));
  }
  ExpectOneLineError(Capture(Live({"--every-frame", "--track"})),
                     "--track: only frames that are streamed are tracked");
}

TEST_F(CaptureTest, SaysWhereTheIntrinsicsComeFrom) {
  const std::string file =
      folder_.Write("camera.json", R"({"fx": 260, "fy": 261, "cx": 159.5, "cy": 119.5, "width": 320,
                         "height": 240})");
  const std::vector<std::string> one{"--every-frame", "--frames", "1"};
  const auto run = [&](std::vector<std::string> flags) {
    flags.insert(flags.end(), one.begin(), one.end());
    return Capture(Live(flags)).err;
  };
  EXPECT_THAT(run({}), HasSubstr("fx 262.5, fy 262.5, cx 159.5, cy 119.5, from the field of view"));
  EXPECT_THAT(run({"--calibration", file}), HasSubstr("fx 260.0, fy 261.0, cx 159.5, cy 119.5, "
                                                      "from the calibration file " +
                                                      file));
  EXPECT_THAT(run({"--intrinsics", "250,251,160,120"}),
              HasSubstr("fx 250.0, fy 251.0, cx 160.0, cy 120.0, as given by --intrinsics"));
}

TEST_F(CaptureTest, EndsCleanlyOnSignals) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Process capture(CommandLine(Live(), {{"FOVEA_CAMERA_FPS", "30"}}));
    EXPECT_THAT(ReadAnswer(capture), HasSubstr(" objects"));
    capture.Signal(signal);
    const Finished finished = capture.Wait();
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_EQ(CountOf(finished.out, "lost\n"), 0) << finished.out;
  }
}

TEST_F(CaptureTest, GoesOnWhenItsServerComesBack) {
  Process capture(CommandLine(Live(), {{"FOVEA_CAMERA_FPS", "30"}}));
  std::string out = capture.ReadLine() + "\n";
  server_.process().Signal(SIGKILL);
  server_.process().Wait();
  capture.AwaitError("the server at " + server_.address() + " is away; waiting");
  Process again({FOVEA_SERVER, "--listen", server_.address()});
  EXPECT_THAT(again.ReadLine(), HasSubstr("listening on " + server_.address()));
  capture.AwaitError("the server at " + server_.address() + " is back");
  for (std::string line;
       (line = capture.ReadLine()).find("lost with the connection") == std::string::npos;) {
    ASSERT_NE(line, "") << "it ended: " << capture.Wait().err;
  }
  capture.Signal(SIGINT);
  const Finished finished = capture.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_GE(CountOf(finished.out, "lost\n"), 1) << finished.out;
  ExpectAllAccountedFor(finished.out);
}

TEST_F(CaptureTest, SaysThatItsServerIsSilent) {
  Process capture(CommandLine(Live(), {{"FOVEA_CAMERA_FPS", "30"}}));
  capture.ReadLine();
  server_.process().Signal(SIGSTOP);
  capture.AwaitError("the server at " + server_.address() + " has not answered for 3 s; waiting");
  server_.process().Signal(SIGCONT);
  capture.AwaitError("the server at " + server_.address() + " is back");
  capture.Signal(SIGINT);
  EXPECT_EQ(capture.Wait().exit_code, 0);
}

TEST_F(CaptureTest, AnotherSignalEndsTheWaitForTheLastAnswers) {
  std::vector<std::string> command = CommandLine(Live(), {{"FOVEA_CAMERA_FPS", "30"}});
  const auto limit = std::ranges::find(command, "timeout");
  command.erase(limit, limit + 3);  // it passes each signal on twice
  Process capture(command);
  capture.ReadLine();
  server_.process().Signal(SIGSTOP);
  capture.AwaitError("the server at " + server_.address() + " has not answered for 3 s; waiting");
  capture.Signal(SIGINT);
  capture.AwaitError("waiting for the last answers, 10 s at most; Ctrl-C or another signal");
  capture.Signal(SIGINT);
  const Finished finished = capture.Wait();
  server_.process().Signal(SIGCONT);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("the last answers did not come in time"));
  ExpectAllAccountedFor(finished.out);
}

TEST_F(CaptureTest, EndsCleanlyWhereItsServerGoesWithTheLastAnswers) {
  Process capture(CommandLine(Live(), {{"FOVEA_CAMERA_FPS", "30"}}));
  capture.ReadLine();
  server_.process().Signal(SIGSTOP);
  capture.AwaitError("the server at " + server_.address() + " has not answered for 3 s; waiting");
  capture.Signal(SIGINT);
  server_.process().Signal(SIGKILL);
  server_.process().Wait();
  Process again({FOVEA_SERVER, "--listen", server_.address()});
  EXPECT_THAT(again.ReadLine(), HasSubstr("listening on " + server_.address()));
  const Finished finished = capture.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_GE(CountOf(finished.out, "lost\n"), 1) << finished.out;
  ExpectAllAccountedFor(finished.out);
}

TEST_F(CaptureTest, LosesNothingWhereEveryFrameWaitsForTheServer) {
  Process capture(CommandLine(Live({"--every-frame", "--frames", "30"})));
  capture.ReadLine();
  server_.process().Signal(SIGKILL);
  server_.process().Wait();
  capture.AwaitError("the server at " + server_.address() + " is away; waiting");
  Process again({FOVEA_SERVER, "--listen", server_.address()});
  const Finished finished = capture.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("the server at " + server_.address() + " is back\n"));
  EXPECT_EQ(CountOf(finished.out, "answered"), 30) << finished.out;
  EXPECT_EQ(CountOf(finished.out, "lost\n"), 0);
}

TEST_F(CaptureTest, ShowsAWindow) {
  const Finished finished = Capture(Live({"--view", "--frames", "5"}),
                                    {{"QT_QPA_PLATFORM", "offscreen"}, {"FOVEA_CAMERA_FPS", "30"}});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(CountOf(finished.out, "frames captured"), 5);
  const Environment nowhere{{"QT_QPA_PLATFORM", ""}, {"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
  ExpectOneLineError(Capture(Live({"--view"}), nowhere), "--view needs a display");
  const Environment unreachable{
      {"QT_QPA_PLATFORM", ""}, {"DISPLAY", ":12345"}, {"WAYLAND_DISPLAY", ""}};
  ExpectOneLineError(Capture(Live({"--view"}), unreachable), "no window opens on DISPLAY=:12345");
}

}  // namespace
}  // namespace fovea::testing
