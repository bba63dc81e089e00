// Everything that can be wrong with a camera or a server has its word.
#include <gmock/gmock.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <signal.h>

#include <filesystem>
#include <opencv2/core.hpp>

#include "fovea/v1/detection_service.grpc.pb.h"
#include "tests/capture/capture_process.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class MishapsTest : public CaptureTest {
 protected:
  static constexpr std::size_t kNumFrames = 6;

  Finished With(const std::string& faults, std::vector<std::string> flags = {}) const {
    flags.insert(flags.end(), {"--frames", std::to_string(kNumFrames), "--every-frame"});
    return Capture(Live(flags), {{"FOVEA_CAMERA_FAULTS", faults}});
  }
};

TEST_F(MishapsTest, NoCamera) {
  ExpectOneLineError(With("no-device"), "no camera found");
  ExpectOneLineError(With("", {"--device", "1d27/0609@1/3"}),
                     "no camera 1d27/0609@1/3 found; plugged in: fovea/test@0/1");
  ExpectOneLineError(Capture(Record(At("a.oni")), {{"FOVEA_CAMERA_FAULTS", "no-device"}}),
                     "no camera found");
}

TEST_F(MishapsTest, DevicesWithoutACamera) {
  ExpectOneLineError(Capture({"devices"}, {{"FOVEA_CAMERA_FAULTS", "no-device"}}),
                     "no camera found");
  const Finished denied = Capture({"devices"}, {{"FOVEA_CAMERA_FAULTS", "denied"}});
  EXPECT_EQ(denied.exit_code, 0) << denied.err;
  EXPECT_THAT(denied.out, StartsWith("fovea/test@0/1  Fovea, Test camera  does not open: "));
  EXPECT_THAT(Capture({"devcies"}).err, HasSubstr("did you mean devices?"));
}

// Neither camera nor server is there to be asked.
TEST_F(MishapsTest, FlagsThatAreWrongEndItAtOnce) {
  const std::string other =
      folder_.Write("k.json", R"({"fx": 1, "fy": 1, "cx": 1, "cy": 1, "width": 4, "height": 4})");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--calibration", At("none")}, "cannot read " + At("none")},
      {{"--calibration", other}, other + ": it is for 4x4, the camera sends 320x240"},
      {{"--intrinsics", other}, other + ": it is for 4x4, the camera sends 320x240"},
      {{"--intrinsics", "1,2"},
       "--intrinsics: \"1,2\" is not FX,FY,CX,CY, and not a file that is there"},
      {{"--intrinsics", "0,1,1,1"}, "--intrinsics: \"0,1,1,1\": focal lengths must be above 0"},
      {{"--distortion", "magic=1"}, "--distortion: "},
      {{"--device", At("none.oni")}, "there is no recording " + At("none.oni")},
      {{"--save", other}, "--save: cannot write " + other}};
  for (auto [flags, error] : cases) {
    flags.insert(flags.end(), {"--server", "unix:" + At("none"), "--resolution", "320x240"});
    ExpectOneLineError(Capture(flags, {{"FOVEA_CAMERA_FAULTS", "no-device"}}), error);
  }
  for (const std::string flag : {"--calibration", "--intrinsics"}) {
    ExpectOneLineError(
        Capture(Record(At("a.oni"), {flag, "none"}), {{"FOVEA_CAMERA_FAULTS", "no-device"}}),
        flag == "--calibration" ? "cannot read none" : "--intrinsics: \"none\"");
  }
}

TEST_F(MishapsTest, AnOptionThatIsNone) {
  const Finished live = Capture(Live({"--set", "no.such=1", "--seconds", "60"}));
  EXPECT_EQ(live.exit_code, 1);
  EXPECT_THAT(live.err, HasSubstr("fovea-capture: options.parameters[no.such]: "));
}

TEST_F(MishapsTest, NoPermission) {
  const Finished finished = With("denied");
  ExpectOneLineError(finished, "no permission to open the camera fovea/test@0/1");
  ExpectOneLineError(finished, "60-libopenni2-0.rules of the package libopenni2-0");
}

TEST_F(MishapsTest, UnsupportedMode) {
  const auto run = [&](const std::vector<std::string>& flags) {
    std::vector<std::string> command{"--server", server_.address()};
    command.insert(command.end(), flags.begin(), flags.end());
    return Capture(command);
  };
  // Colour alone has it.
  ExpectOneLineError(run({"--resolution", "640x480"}),
                     "no mode 640x480 at 30 frames/s for colour and depth; it has: 320x240 at 15, "
                     "320x240 at 30");
  ExpectOneLineError(run({"--resolution", "320x240", "--fps", "60"}), "no mode 320x240 at 60");
  ExpectOneLineError(run({"--resolution", "big"}), "--resolution: \"big\"");
}

// NaN is in no range, and compares as if it were in each.
TEST_F(MishapsTest, NumbersThatAreNone) {
  for (const char* flag : {"--seconds", "--patience", "--frame-timeout", "--depth-unit"}) {
    const Finished finished = Capture(Live({flag, "nan", "--frames", "1"}));
    EXPECT_NE(finished.exit_code, 0) << flag;
    EXPECT_THAT(finished.err, HasSubstr(std::string(flag) + ": \"nan\" is not a number from "));
  }
  EXPECT_THAT(Capture(Replay(At("a.oni"), {"--speed", "nan"})).err, HasSubstr("--speed: \"nan\""));
}

TEST_F(MishapsTest, NoRegistration) {
  ExpectOneLineError(With("no-registration"), "does not register depth to colour");
  const Finished anyway = With("no-registration", {"--allow-unregistered"});
  EXPECT_EQ(anyway.exit_code, 0) << anyway.err;
  EXPECT_THAT(anyway.err, HasSubstr("note: the camera fovea/test@0/1 does not register"));
  EXPECT_EQ(With("late-registration").exit_code, 0);
}

TEST_F(MishapsTest, NoFrames) {
  ExpectOneLineError(With("silent", {"--frame-timeout", "0.3"}),
                     "no frames arrive from fovea/test@0/1 for 0.3 s: USB bandwidth?");
}

TEST_F(MishapsTest, WrongSize) {
  ExpectOneLineError(With("wrong-size", {"--frame-timeout", "0.3"}),
                     "sends images of another size than 320x240");
}

TEST_F(MishapsTest, PairsWholeImagesOfOneMomentOnly) {
  for (const std::string fault : {"drop-color", "late-color", "half"}) {
    const Finished finished = With(fault, {"--save", At(fault)});
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    const std::vector<SavedFrame> saved = Saved(At(fault));
    EXPECT_EQ(saved.size(), kNumFrames);
    for (const SavedFrame& frame : saved) {
      EXPECT_EQ(cv::norm(frame.color, frames_[frame.generated].frame.color_rgb, cv::NORM_INF), 0)
          << fault << ' ' << frame.name;
    }
    // A late image loses nothing, a missing one leaves its partner alone.
    EXPECT_EQ(CountOf(finished.out, "images without a partner"), fault == "late-color" ? -1 : 1)
        << finished.out;
  }
}

TEST_F(MishapsTest, ComesBackAfterUnplugging) {
  const Environment environment{{"FOVEA_CAMERA_CONTROL", At("unplugged")},
                                {"FOVEA_CAMERA_FPS", "30"}};
  Process capture(CommandLine(Live(), environment));
  EXPECT_THAT(ReadAnswer(capture), HasSubstr(" objects"));
  folder_.Write("unplugged", "");
  capture.AwaitError("the camera fovea/test@0/1 was unplugged; waiting");
  std::filesystem::remove(At("unplugged"));
  capture.AwaitError("the camera fovea/test@0/1 is back");
  // More answers than can have been under way.
  for (int i = 0; i < 5; ++i) EXPECT_THAT(ReadAnswer(capture), HasSubstr(" objects"));
  capture.Signal(SIGINT);
  const Finished finished = capture.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("reopened 1 times"));
}

// One that hangs without being unplugged is opened anew, which may not help at once.
TEST_F(MishapsTest, WaitsForACameraThatHangs) {
  const Finished finished = With("hangs", {"--frame-timeout", "1"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_THAT(finished.err, HasSubstr("no frames arrive from fovea/test@0/1 for 1 s; waiting"));
  EXPECT_THAT(finished.err, HasSubstr("the camera fovea/test@0/1 is back"));
  EXPECT_THAT(finished.out, HasSubstr("reopened 1 times"));
}

TEST_F(MishapsTest, GivesUpOnACameraThatHangsForLong) {
  const Finished finished = With("hangs", {"--frame-timeout", "1", "--patience", "0.2"});
  ExpectOneLineError(finished, "the camera did not come back: no frames arrive from");
  EXPECT_THAT(finished.err, Not(HasSubstr("is back")));
}

TEST_F(MishapsTest, GivesUpOnACameraThatStaysAway) {
  const Environment environment{{"FOVEA_CAMERA_CONTROL", At("unplugged")},
                                {"FOVEA_CAMERA_FPS", "30"}};
  Process capture(CommandLine(Live({"--patience", "0.2"}), environment));
  capture.ReadLine();
  folder_.Write("unplugged", "");
  ExpectOneLineError(capture.Wait(), "the camera did not come back: no camera found");
}

TEST_F(MishapsTest, NoServer) {
  const std::string address = server_.address();
  server_.process().Signal(SIGTERM);
  server_.process().Wait();
  ExpectOneLineError(With(""), "no server answers at " + address);
}

class FutureServer : public v1::DetectionService::Service {
  grpc::Status GetServerInfo(grpc::ServerContext*, const v1::GetServerInfoRequest*,
                             v1::GetServerInfoResponse* response) override {
    response->set_version("7.0.0");
    return grpc::Status::OK;
  }
};

TEST_F(MishapsTest, ServerOfAnotherVersion) {
  FutureServer service;
  int port = 0;
  const auto server = grpc::ServerBuilder()
                          .AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port)
                          .RegisterService(&service)
                          .BuildAndStart();
  ExpectOneLineError(Capture({"--server", "127.0.0.1:" + std::to_string(port)}),
                     "the server is fovea 7.0.0, this client ");
}

TEST_F(MishapsTest, ServerThatRefusesFrames) {
  const Finished finished = With("", {"--set", "no.such=1"});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_THAT(finished.out, HasSubstr("000001  failed: options.parameters[no.such]"));
  EXPECT_EQ(CountOf(finished.out, "failed;"), 1) << "it would refuse them all";
}

TEST_F(MishapsTest, FolderWithFramesOfAnotherRun) {
  EXPECT_EQ(With("", {"--save", At("out")}).exit_code, 0);
  std::filesystem::remove(At("out/000001_color.png"));
  const Finished again = With("", {"--save", At("out")});
  ExpectOneLineError(again, "--save: " + At("out") + " holds frames already, such as 00000");
  EXPECT_EQ(again.out, "");
  EXPECT_FALSE(std::filesystem::exists(At("out/000001_color.png"))) << "nothing is captured";
  // What else lies there is no frame.
  std::filesystem::create_directory(At("other"));
  folder_.Write("other/notes.txt", "of the cell");
  EXPECT_EQ(With("", {"--save", At("other")}).exit_code, 0);
}

TEST_F(MishapsTest, MisspeltFlags) {
  ExpectOneLineError(Capture({"--bogus"}), "--bogus");
  ExpectOneLineError(Capture(Live({"--color-encoding", "gif"})), "\"gif\" is not jpeg or rgb8");
  ExpectOneLineError(Capture(Live({"--calibration", At("none.yaml")})),
                     "cannot read " + At("none.yaml"));
}

}  // namespace
}  // namespace fovea::testing
