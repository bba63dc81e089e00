#include "tests/capture/capture_process.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <regex>

#include "tests/support/random_scene.h"
#include "tests/support/scene_files.h"

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;

constexpr int kNumFrames = 3;
const cv::Size kSize{320, 240};

std::string BytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string WithoutNamesAndTimes(const std::string& text) {
  nlohmann::json json = nlohmann::json::parse(text);
  for (const char* key : {"frame_id", "captured_at", "stage_times"}) json.erase(key);
  for (auto& object : json["objects"]) object.erase("id");
  return json.dump();
}

bool Same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

}  // namespace

CaptureTest::CaptureTest() {
  fs::create_directory(At("frames"));
  for (int i = 0; i < kNumFrames; ++i) {
    const auto seed = static_cast<std::uint64_t>(5 + i);
    frames_.push_back(scenes::MakeFrame(scenes::RandomScene("tabletop", seed, kSize),
                                        scenes::SensorKind::kKinect, seed));
    scenes::WriteFrame(At("frames"), std::to_string(i), frames_.back());
  }
}

std::vector<std::string> CaptureTest::CommandLine(const std::vector<std::string>& arguments,
                                                  const Environment& environment) const {
  // OpenNI2 and its stock drivers leak a little when they end, which asan would take for ours.
  Environment all{{"LD_LIBRARY_PATH", FOVEA_OPENNI},
                  {"FOVEA_CAMERA_FRAMES", At("frames")},
                  {"LSAN_OPTIONS", "detect_leaks=0"}};
  for (const auto& [name, value] : environment) all[name] = value;
  std::vector<std::string> command{"/usr/bin/env"};
  for (const auto& [name, value] : all) command.push_back(name + "=" + value);
  command.insert(command.end(), {"timeout", "--kill-after=5", "120", FOVEA_CAPTURE});
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

Finished CaptureTest::Capture(const std::vector<std::string>& arguments,
                              const Environment& environment) const {
  return Execute(CommandLine(arguments, environment));
}

std::vector<std::string> CaptureTest::Live(std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), {"--server", server_.address(), "--resolution", "320x240"});
  return arguments;
}

std::vector<std::string> CaptureTest::Replay(const std::string& recording,
                                             std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), {"replay", recording, "--server", server_.address()});
  return arguments;
}

std::vector<std::string> CaptureTest::Record(const std::string& recording,
                                             std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), {"record", recording, "--resolution", "320x240"});
  return arguments;
}

std::vector<SavedFrame> CaptureTest::Saved(const std::string& folder) const {
  std::vector<SavedFrame> saved;
  for (int number = 1; number < 1000; ++number) {
    char name[16];
    std::snprintf(name, sizeof name, "%06d", number);
    const std::string prefix = folder + "/" + name;
    if (!fs::exists(prefix + ".png")) continue;
    SavedFrame frame{.name = name,
                     .color = cv::imread(prefix + "_color.png"),
                     .labels = cv::imread(prefix + ".png", cv::IMREAD_UNCHANGED),
                     .label_file = BytesOf(prefix + ".png"),
                     .json = WithoutNamesAndTimes(BytesOf(prefix + ".json"))};
    cv::cvtColor(frame.color, frame.color, cv::COLOR_BGR2RGB);
    const cv::Mat depth = cv::imread(prefix + "_depth.png", cv::IMREAD_UNCHANGED);
    while (frame.generated < frames_.size() &&
           !Same(depth, cv::imread(At("frames/" + std::to_string(frame.generated) + "_depth.png"),
                                   cv::IMREAD_UNCHANGED))) {
      ++frame.generated;
    }
    EXPECT_LT(frame.generated, frames_.size()) << frame.name << " is no frame of the camera";
    if (frame.generated < frames_.size()) saved.push_back(frame);
  }
  return saved;
}

std::string CaptureTest::ReadAnswer(Process& capture) {
  std::string line = capture.ReadLine();
  while (line.starts_with("note: ")) line = capture.ReadLine();
  return line;
}

void CaptureTest::ExpectOneLineError(const Finished& finished, const std::string& text) {
  EXPECT_EQ(finished.exit_code, 1);
  // Notes may stand above it.
  const std::size_t start = finished.err.find("fovea-capture: ");
  ASSERT_NE(start, std::string::npos) << finished.err;
  const std::string error = finished.err.substr(start);
  EXPECT_THAT(error, ::testing::HasSubstr(text));
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
}

int CountOf(const std::string& summary, const std::string& text) {
  std::smatch match;
  if (!std::regex_search(summary, match, std::regex("([0-9]+) " + text))) return -1;
  return std::stoi(match[1]);
}

}  // namespace fovea::testing
