// Recordings: made from the test camera, played by OpenNI2's own driver for files.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <set>
#include <thread>

#include "tests/capture/capture_process.h"

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Waits until the file has grown to this size; where it does not in a minute, the recording ends
// and what it said is printed.
bool Holds(const std::string& path, std::uintmax_t num_bytes, Process& record) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (std::chrono::steady_clock::now() < deadline) {
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(path, missing);
    if (!missing && size >= num_bytes) return true;
    std::this_thread::yield();
  }
  record.Signal(SIGTERM);
  const Finished finished = record.Wait();
  ADD_FAILURE() << finished.out << finished.err;
  return false;
}

std::string TextOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class RecordingTest : public CaptureTest {
 protected:
  // A recording of at least seven frames.
  std::string Recorded(const Environment& environment = {}) const {
    const Finished finished = Capture(Record(At("a.oni"), {"--frames", "7"}), environment);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_GE(CountOf(finished.out, "frames in"), 7) << finished.out;
    return At("a.oni");
  }

  std::vector<SavedFrame> SavedByReplay(const std::string& recording, const std::string& folder,
                                        std::vector<std::string> flags = {}) const {
    flags.insert(flags.begin(), {"--color-encoding", "rgb8", "--save", folder});
    const Finished finished = Capture(Replay(recording, flags));
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("end of the recording\n"));
    EXPECT_EQ(CountOf(finished.out, "frames captured"), CountOf(finished.out, "answered"));
    EXPECT_EQ(CountOf(finished.out, "by the camera"), 0) << finished.out;
    std::vector<SavedFrame> saved = Saved(folder);
    for (const SavedFrame& frame : saved) {
      EXPECT_EQ(cv::norm(frame.color, frames_[frame.generated].frame.color_rgb, cv::NORM_INF), 0)
          << "colour and depth of " << frame.name << " are of two moments";
    }
    return saved;
  }
};

TEST_F(RecordingTest, ReplayGivesExactlyWhatTheLiveRunGave) {
  const Finished live =
      Capture(Live({"--color-encoding", "rgb8", "--frames", "12", "--save", At("live")}),
              {{"FOVEA_CAMERA_FPS", "30"}});
  ASSERT_EQ(live.exit_code, 0) << live.err;
  std::vector<SavedFrame> live_frames(frames_.size());
  for (const SavedFrame& frame : Saved(At("live"))) live_frames[frame.generated] = frame;

  std::set<std::size_t> compared;
  for (const SavedFrame& frame : SavedByReplay(Recorded(), At("replay"))) {
    const SavedFrame& expected = live_frames[frame.generated];
    if (expected.name.empty()) continue;  // the live run dropped it
    compared.insert(frame.generated);
    EXPECT_TRUE(frame.label_file == expected.label_file) << frame.name;  // prints no bytes
    EXPECT_EQ(frame.json, expected.json) << frame.name;
    EXPECT_EQ(cv::norm(frame.color, expected.color, cv::NORM_INF), 0) << frame.name;
  }
  EXPECT_FALSE(compared.empty());
}

TEST_F(RecordingTest, ReplaysAllFramesInOrderEachTime) {
  const std::string recording = Recorded();
  const auto first = SavedByReplay(recording, At("first"));
  const auto second = SavedByReplay(recording, At("second"));
  ASSERT_GE(first.size(), 7U);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].generated, (first[0].generated + i) % frames_.size());
    EXPECT_TRUE(first[i].label_file == second[i].label_file) << i;
    EXPECT_EQ(first[i].json, second[i].json);
  }
}

TEST_F(RecordingTest, StartsWithColorAndDepthOfOneMoment) {
  // So there is time between the two images of a moment, in which a recording must not begin.
  const std::string recording = Recorded({{"FOVEA_CAMERA_FAULTS", "color-waits"}});
  EXPECT_GE(SavedByReplay(recording, At("out")).size(), 7U);
}

TEST_F(RecordingTest, PlaysAtASpeedLikeACamera) {
  const Finished finished = Capture(Replay(Recorded(), {"--speed", "1"}));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("end of the recording\n"));
  EXPECT_GE(CountOf(finished.out, "answered"), 1);
}

// They are of the live camera: "--server A replay" would have asked another server.
TEST_F(RecordingTest, FlagsBeforeTheCommandAreRefused) {
  for (const char* command : {"replay", "record"}) {
    ExpectOneLineError(Capture({"--server", "localhost:1", command, At("a.oni")}),
                       std::string("--server: flags of ") + command + " stand behind that word");
  }
  ExpectOneLineError(Capture({"--view", "devices"}), "--view: flags of devices stand behind");
}

TEST_F(RecordingTest, HoldsAllFramesThatWereTaken) {
  // Frames come faster than they are written.
  const Finished finished = Capture(Record(At("a.oni"), {"--frames", "40"}));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const int num_recorded = CountOf(finished.out, "frames in");
  EXPECT_GE(num_recorded, 40);
  const Finished replay = Capture(Replay(At("a.oni")));
  EXPECT_GE(CountOf(replay.out, "frames captured"), num_recorded) << replay.err;
}

TEST_F(RecordingTest, SignalsLeaveARecordingThatPlays) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string path = At(std::to_string(signal) + ".oni");
    Process record(CommandLine(Record(path), {{"FOVEA_CAMERA_FPS", "30"}}));
    EXPECT_THAT(record.ReadLine(), HasSubstr("recording fovea/test@0/1 to " + path));
    ASSERT_TRUE(Holds(path, 1'000'000, record));
    record.Signal(signal);
    const Finished finished = record.Wait();
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_GE(SavedByReplay(path, At("out" + std::to_string(signal))).size(), 2U);
  }
}

// As one that is killed leaves it.
TEST_F(RecordingTest, SaysThatAnUnendedRecordingHoldsNothing) {
  Process record(CommandLine(Record(At("a.oni")), {{"FOVEA_CAMERA_FPS", "30"}}));
  EXPECT_THAT(record.ReadLine(), HasSubstr("recording fovea/test@0/1 to "));
  ASSERT_TRUE(Holds(At("a.oni"), 1'000'000, record));
  fs::copy_file(At("a.oni"), At("unended.oni"));
  record.Signal(SIGTERM);
  EXPECT_EQ(record.Wait().exit_code, 0);
  const Finished replay = Capture(Replay(At("unended.oni")));
  EXPECT_NE(replay.exit_code, 0);
  // The latter where the copy ends in the midst of what was being written.
  EXPECT_THAT(replay.err, AnyOf(HasSubstr(At("unended.oni") + " has no frame that can be played"),
                                HasSubstr(At("unended.oni") + " is damaged")));
}

TEST_F(RecordingTest, UnpluggingLeavesARecordingThatPlays) {
  const Environment environment{{"FOVEA_CAMERA_CONTROL", At("unplugged")},
                                {"FOVEA_CAMERA_FPS", "30"}};
  Process record(CommandLine(Record(At("a.oni")), environment));
  EXPECT_THAT(record.ReadLine(), HasSubstr("recording fovea/test@0/1 to " + At("a.oni")));
  ASSERT_TRUE(Holds(At("a.oni"), 1'000'000, record));
  folder_.Write("unplugged", "");
  ExpectOneLineError(record.Wait(), "fovea/test@0/1 was unplugged");
  EXPECT_GE(SavedByReplay(At("a.oni"), At("out")).size(), 2U);
}

TEST_F(RecordingTest, APipeWithoutAReaderLeavesNoRecordingThatDoesNotPlay) {
  ASSERT_EQ(mkfifo(At("pipe").c_str(), S_IRUSR | S_IWUSR), 0);
  // The reading end is closed before anything is written.
  std::vector<std::string> command{"/bin/sh", "-c",
                                   R"(exec 3<>"$0" 4>"$0" 3>&-; exec "$@" >&4 4>&-)", At("pipe")};
  const std::vector<std::string> record = CommandLine(Record(At("a.oni")));
  command.insert(command.end(), record.begin(), record.end());
  EXPECT_EQ(Execute(command).exit_code, 1);
  if (fs::exists(At("a.oni"))) SavedByReplay(At("a.oni"), At("out"));
}

TEST_F(RecordingTest, LeavesNoFileWithoutFrames) {
  ExpectOneLineError(
      Capture(Record(At("a.oni"), {"--frame-timeout", "0.3"}), {{"FOVEA_CAMERA_FAULTS", "silent"}}),
      "no frames arrive");
  EXPECT_FALSE(fs::exists(At("a.oni")));
  EXPECT_FALSE(fs::exists(At("a.intrinsics.json")));
}

// They may be a calibration, and would be those of the new recording.
TEST_F(RecordingTest, LeavesIntrinsicsAloneThatItDidNotWrite) {
  const std::string path = folder_.Write("a.intrinsics.json", "somebody's");
  ExpectOneLineError(Capture(Record(At("a.oni"))), path + " is there already");
  EXPECT_EQ(TextOf(path), "somebody's");
  EXPECT_FALSE(fs::exists(At("a.oni")));
}

TEST_F(RecordingTest, LeavesTheCalibrationThatLiesBesideIt) {
  const std::string calibration =
      R"({"fx": 260, "fy": 261, "cx": 159, "cy": 119, "width": 320, "height": 240})";
  const std::string path = folder_.Write("a.intrinsics.json", calibration);
  for (const char* flag : {"--calibration", "--intrinsics"}) {
    ExpectOneLineError(Capture(Record(At("a.oni"), {flag, path, "--frame-timeout", "0.3"}),
                               {{"FOVEA_CAMERA_FAULTS", "silent"}}),
                       "no frames arrive");
    EXPECT_EQ(TextOf(path), calibration);
  }
  ExpectOneLineError(
      Capture(Record(At("a.oni"), {"--calibration", path, "--distortion", "plumb_bob=0.1,0,0,0"})),
      path + " is there already");
  const Finished finished = Capture(Record(At("a.oni"), {"--calibration", path, "--frames", "2"}));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(TextOf(path), calibration);
  EXPECT_THAT(Capture(Replay(At("a.oni"))).err, HasSubstr("fx 260.0, fy 261.0"));
}

TEST_F(RecordingTest, SaysWhatIsNoRecording) {
  ExpectOneLineError(Capture(Replay(At("none.oni"))), "there is no recording " + At("none.oni"));
  ExpectOneLineError(Capture(Replay(folder_.Write("text.oni", "not a recording"))),
                     "text.oni is not a recording of OpenNI2");
  const std::string other = folder_.Write("color.png", "a picture");
  ExpectOneLineError(Capture(Replay(other)), other + " is not a recording of OpenNI2 (.oni)");
  ExpectOneLineError(Capture(Live({"--device", other})), other + " is not a recording of OpenNI2");
  ExpectOneLineError(
      Capture(Replay(folder_.Write("damaged.oni", "NI10 and not much more than that"))),
      "damaged.oni is damaged");
  ExpectOneLineError(Capture(Record(At("a.avi"))), "a recording's name ends in .oni");
  ExpectOneLineError(Capture(Record(At("text.oni"))), "text.oni is there already");
  ExpectOneLineError(Capture(Record(At("no/folder.oni"))), "cannot record to");
}

// A name of a property that does not end.
TEST_F(RecordingTest, SaysWhichRecordingOpenNiCrashesAt) {
  std::string bytes = TextOf(Recorded());
  const std::string name = "xnSupportedMapOutputModesCount";
  const std::size_t at = bytes.find(name);
  ASSERT_NE(at, std::string::npos);
  bytes.at(at + name.size()) = '\xA2';
  const std::string damaged = folder_.Write("damaged.oni", bytes);
  ExpectOneLineError(Capture(Replay(damaged)),
                     damaged + " is damaged: the reader of OpenNI2 crashed at it (");
}

TEST_F(RecordingTest, AReplayEndsCleanlyByASignal) {
  Process replay(CommandLine(Replay(Recorded(), {"--speed", "0.1"})));
  EXPECT_NE(ReadAnswer(replay), "");
  replay.Signal(SIGTERM);
  const Finished finished = replay.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("frames captured"));
  EXPECT_THAT(finished.out, Not(HasSubstr("end of the recording")));
}

}  // namespace
}  // namespace fovea::testing
