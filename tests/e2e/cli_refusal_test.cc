// What the command line refuses, and how it says what is wrong.
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>

#include "tests/e2e/cli_fixture.h"

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(CliTest, ChecksOutputsBeforeItAsksTheServer) {
  server_.process().Signal(SIGTERM);
  server_.process().Wait();
  const std::string bad = At("no/l.png");
  ExpectOneLineError(DetectFrame({"--json", At("j.json"), "--labels", bad}),
                     "--labels: cannot write " + bad + ": there is no folder " + At("no"));
  ExpectOneLineError(DetectFrame({"--overlay", At("a_color.png")}), "is an image of the frame");
  ExpectOneLineError(DetectFrame({"--labels", At("l.png"), "--overlay", At("./l.png")}),
                     "--overlay: cannot write " + At("./l.png") + ": it is what --labels writes");
  ExpectOneLineError(DetectFrame({"--labels", At("l.jpg")}), "labels need a format without loss");
  ExpectOneLineError(DetectFrame({"--cloud", At("c.stl")}), "--cloud: \"stl\" is not a kind");
  ExpectOneLineError(Detect({"--input", Folder(), "--output", At("a_depth.png")}),
                     "--output: cannot write " + At("a_depth.png"));
}

TEST_F(CliTest, OverwritesNoFileThatItReads) {
  Write("k.txt", "30,30,15.5,11.5");
  Write("token", "secret");
  const std::vector<std::string> frame{
      FOVEA_CLI,         "detect",    "--server",        server_.address(), "--color",
      At("a_color.png"), "--depth",   At("a_depth.png"), "--intrinsics",    At("k.txt"),
      "--token-file",    At("token"), "--json"};
  const auto writing = [&](const std::string& path) {
    std::vector<std::string> command = frame;
    command.push_back(path);
    return Execute(command);
  };
  ExpectOneLineError(writing(At("k.txt")), "k.txt: it is what --intrinsics names");
  ExpectOneLineError(writing(At("./token")), "token: it is what --token-file names");
  EXPECT_EQ(writing(At("j.json")).exit_code, 0);
}

// Of a plane that fills the picture no level surface and no object can be made out.
TEST_F(CliTest, SaysWhyAFrameHasNoObjects) {
  const Finished one = DetectFrame();
  EXPECT_THAT(one.out, StartsWith("a: 0 objects in"));
  EXPECT_THAT(one.out, HasSubstr("\nnote: "));
  const Finished many = Detect({"--input", Folder(), "--output", At("out")});
  EXPECT_THAT(many.out, StartsWith("1/1  a: 0 objects\n  note: "));
}

TEST_F(CliTest, SaysInOneLineWhatIsWrong) {
  ExpectOneLineError(DetectFrame({"--bogus"}), "--bogus");
  ExpectOneLineError(DetectFrame({"--overlai", At("o.png")}), "did you mean --overlay?");
  ExpectOneLineError(Execute({FOVEA_CLI, "detct"}), "did you mean detect?");
  ExpectOneLineError(DetectFrame({"--gripper", "claw=1"}), "--gripper: \"claw=1\" is not jaw=");
  ExpectOneLineError(DetectFrame({"--place", "1,2"}), "--place: \"1,2\" is not LENGTH");
  ExpectOneLineError(DetectFrame({"--show", "grasps"}), "--show needs --overlay");
  ExpectOneLineError(
      Detect({"--input", Folder(), "--output", At("out"), "--no-overlay", "--show", "seeds"}),
      "--show needs overlays");
  ExpectOneLineError(DetectFrame({"--resume"}), "--resume requires --input");
  ExpectOneLineError(Detect({"--input", Folder(), "--json", "-", "--resume"}),
                     "--resume needs --output");
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
  ExpectOneLineError(DetectFrame({"--tls-ca", At("none")}), "--tls-ca: cannot read " + At("none"));
  ExpectOneLineError(DetectFrame({"--tls-ca", ""}), "--tls-ca: is empty");
  ExpectOneLineError(DetectFrame({"--token-file", Folder()}), "--token-file: cannot read ");
  ExpectOneLineError(DetectFrame({"--no-masks="}), "--no-masks: is empty");
  ExpectOneLineError(
      DetectFrame({"--depth-intrinsics", "0,1,1,1", "--color-from-depth", "0,0,0,0,0,0,1"}),
      "--depth-intrinsics: \"0,1,1,1\": focal lengths must be above 0");
  ExpectOneLineError(DetectFrame({"--input", Folder()}), "--output");
  ExpectOneLineError(Detect({}), "--color");
  ExpectOneLineError(Execute({FOVEA_CLI, "detect", "--colour", "c.png"}), "--colour");
  ExpectOneLineError(Execute({FOVEA_CLI, "detect", "--color", "c.png"}), "--intrinsics");
  ExpectOneLineError(Detect({"--color", At("none.png"), "--depth", At("a_depth.png")}),
                     "cannot read " + At("none.png"));
  ExpectOneLineError(Detect({"--color", Folder(), "--depth", At("a_depth.png")}), "is a folder");
  ExpectOneLineError(Detect({"--input", At("none"), "--output", At("out")}), "cannot read");
  Write("b.bag", "#ROSBAG V2.0");
  ExpectOneLineError(Execute({FOVEA_CLI, "detect", "--input", At("b.bag"), "--output", At("out")}),
                     "bags of ROS 1 have to be converted");
  fs::create_directory(At("empty"));
  ExpectOneLineError(Detect({"--input", At("empty"), "--output", At("out")}), "no NAME_color.png");
}

// A device that has no end took 2 GB of memory before it was refused.
TEST_F(CliTest, ReadsTextOfFlagsUpToALimit) {
  for (const char* flag : {"--token-file", "--tls-ca"}) {
    ExpectOneLineError(DetectFrame({flag, "/dev/zero"}),
                       flag + std::string(": /dev/zero has more than 16 MiB"));
  }
  ExpectOneLineError(Execute({FOVEA_CLI, "detect", "--color", At("a_color.png"), "--depth",
                              At("a_depth.png"), "--intrinsics", "/dev/zero"}),
                     "/dev/zero has more than 16 MiB");
}

TEST_F(CliTest, EndsAFolderWhereAllFramesHaveOneMistake) {
  WriteFrame("b");
  const auto folder_with = [&](const std::string& flag, const std::string& value) {
    return Detect({"--input", Folder(), "--output", At("out"), flag, value});
  };
  ExpectOneLineError(folder_with("--set", "no.such=1"), "options.parameters[no.such]: ");
  ExpectOneLineError(folder_with("--gravity", "0,0,2"), "INVALID_ARGUMENT: frame.gravity: ");
}

TEST_F(CliTest, AsksForHealth) {
  const Finished healthy = Execute({FOVEA_CLI, "health", "--server", server_.address()});
  EXPECT_EQ(healthy.exit_code, 0);
  EXPECT_EQ(healthy.out, server_.address() + " is serving\n");

  const Finished beside_a_proxy =
      Execute({"env", "http_proxy=http://127.0.0.1:1", "no_proxy=", FOVEA_CLI, "health", "--server",
               server_.address()});
  EXPECT_EQ(beside_a_proxy.exit_code, 0) << beside_a_proxy.err;

  const std::string text = "no server answers at " + server_.address();
  server_.process().Signal(SIGTERM);
  server_.process().Wait();
  const ServerProcess other;
  const std::string both = server_.address() + "," + other.address();
  const Finished half = Execute({FOVEA_CLI, "health", "--server", both});
  EXPECT_EQ(half.exit_code, 1);
  EXPECT_EQ(half.out, other.address() + " is serving\n") << "and the other one is not";
  EXPECT_THAT(half.err, StartsWith("fovea: " + text + ";"));
  EXPECT_THAT(Execute({FOVEA_CLI, "info", "--server", both}).out,
              StartsWith("{\n\"address\": \"" + other.address() + "\","));
  EXPECT_THAT(Execute({FOVEA_CLI, "options", "--server", both}).out,
              StartsWith(other.address() + ":\noption "));
  ExpectOneLineError(Execute({FOVEA_CLI, "health", "--server", server_.address()}), text);
  ExpectOneLineError(DetectFrame(), text);
  WriteFrame("b");
  const Finished folder = Detect({"--input", Folder(), "--output", At("out"), "--timeout", "0.1"});
  EXPECT_EQ(folder.exit_code, 1);
  EXPECT_THAT(folder.err, StartsWith("note: " + text));
  EXPECT_THAT(folder.err, HasSubstr("it is waited for, 0.1 s at most\nfovea: " + text));
  EXPECT_EQ(std::ranges::count(folder.err, '\n'), 2) << "it is no matter of frames";
}

// They would steer a terminal, and look like lines that the program wrote.
TEST_F(CliTest, ShowsControlCharactersAsText) {
  ExpectOneLineError(Execute({FOVEA_CLI, "health", "--robot", "a\nb\x1B[2J"}),
                     "--robot: \"a\\nb\\x1b[2J\" has characters");
  ExpectOneLineError(Execute({FOVEA_CLI, "he\nalth"}), "did you mean health?");
  ExpectOneLineError(DetectFrame({"--profile", "fast\n"}), "options.profile: ");
  ExpectOneLineError(DetectFrame({"--fa\nst"}), "--fa\\nst");
}

}  // namespace
}  // namespace fovea::testing
