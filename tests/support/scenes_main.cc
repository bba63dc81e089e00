// fovea-scenes: writes generated RGB-D frames with ground truth.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>

#include "flags/misspelling.h"
#include "tests/support/depth_camera.h"
#include "tests/support/preview.h"
#include "tests/support/random_scene.h"
#include "tests/support/scene_files.h"
#include "tests/support/sensor_names.h"

namespace fovea::scenes {
namespace {

struct Flags {
  std::string output;
  std::string kind = "all";
  int count = 1;
  std::uint64_t seed = 1;
  SensorKind sensor = SensorKind::kKinect;
  std::string size = "640x480";
  double roll_deg = 0;
  std::string depth_size;  // of a depth camera of its own; empty = depth is registered
  bool preview = false;
};

cv::Size ParseSize(const std::string& flag, const std::string& text) {
  constexpr int kLeast = 10, kMost = 9999;
  const auto is_side = [](int value) { return value >= kLeast && value <= kMost; };
  std::istringstream in(text);
  cv::Size size;
  char x = 0;
  in >> size.width >> x >> size.height;
  if (!in || !in.eof() || x != 'x' || !is_side(size.width) || !is_side(size.height)) {
    throw std::invalid_argument(flag + " " + text + ": expected WIDTHxHEIGHT in pixels, of " +
                                std::to_string(kLeast) + " to " + std::to_string(kMost));
  }
  return size;
}

std::optional<DepthCamera> DepthCameraOf(const Flags& flags) {
  constexpr double kBaseline_m = 0.025;
  if (flags.depth_size.empty()) return std::nullopt;
  return DepthCameraBeside(kBaseline_m, ParseSize("--depth-camera", flags.depth_size));
}

std::string Text(const CameraIntrinsics& k) {
  std::ostringstream text;
  text << k.fx_px << ',' << k.fy_px << ',' << k.cx_px << ',' << k.cy_px;
  return text.str();
}

// As `fovea detect` takes them.
std::string FlagsOf(const DepthCamera& camera) {
  const Eigen::Vector3d p = camera.color_from_depth.translation();
  const Eigen::Quaterniond q(camera.color_from_depth.linear());
  std::ostringstream text;
  text << " --depth-intrinsics " << Text(camera.intrinsics) << " --color-from-depth " << p.x()
       << ',' << p.y() << ',' << p.z() << ',' << q.x() << ',' << q.y() << ',' << q.z() << ','
       << q.w();
  return text.str();
}

void ShowProgress(std::size_t done, std::size_t total, const std::string& name) {
  if (isatty(STDERR_FILENO) == 0) return;
  std::cerr << "\r\33[2K" << '[' << done << '/' << total << "] " << name << std::flush;
  if (done == total) std::cerr << '\n';
}

void WriteFrames(const Flags& flags) {
  const cv::Size size_px = ParseSize("--size", flags.size);
  const std::optional<DepthCamera> depth_camera = DepthCameraOf(flags);
  std::vector<std::string> kinds = {flags.kind};
  if (flags.kind == "all") kinds = SceneKinds();
  std::filesystem::create_directories(flags.output);
  const std::size_t total = kinds.size() * static_cast<std::size_t>(flags.count);
  std::size_t done = 0;
  for (const std::string& kind : kinds) {
    for (int i = 0; i < flags.count; ++i) {
      const std::uint64_t seed = flags.seed + static_cast<std::uint64_t>(i);
      const std::string name = kind + "_" + std::to_string(seed);
      const Scene scene =
          Rolled(RandomScene(kind, seed, size_px), flags.roll_deg * std::numbers::pi / 180);
      LabelledFrame frame = MakeFrame(scene, flags.sensor, seed);
      if (depth_camera) {
        frame.frame.depth_m = MeasureDepth(scene, *depth_camera, flags.sensor, seed);
      }
      WriteFrame(flags.output, name, frame);
      if (flags.preview) {
        WriteImage(flags.output + "/" + name + "_preview.png", DrawPreview(frame));
      }
      ShowProgress(++done, total, name);
    }
  }
  std::cout << total << " frames in " << flags.output << ", intrinsics "
            << Text(CameraOfSize(size_px).intrinsics);
  if (depth_camera) std::cout << FlagsOf(*depth_camera);
  std::cout << '\n';
}

int Run(int argc, char** argv) {
  CLI::App app{"Writes generated RGB-D frames with exact ground truth.", "fovea-scenes"};
  Flags flags;
  std::vector<std::string> kinds = SceneKinds();
  kinds.emplace_back("all");
  app.add_option("--output", flags.output, "Folder for the files; made if missing")->required();
  app.add_option("--kind", flags.kind, "Kind of scene")
      ->check(CLI::IsMember(kinds))
      ->capture_default_str();
  app.add_option("--count", flags.count, "Scenes of each kind")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--seed", flags.seed, "Seed of the first scene; the next ones count up")
      ->capture_default_str();
  app.add_option("--sensor", flags.sensor, "That sees the depth; kinect where none is named")
      ->transform(CLI::CheckedTransformer(SensorsByName()));
  app.add_option("--size", flags.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  app.add_option("--roll", flags.roll_deg, "Turns the camera about its optical axis; degrees")
      ->check(CLI::Range(-180.0, 180.0));
  CLI::Option* preview =
      app.add_flag("--preview", flags.preview,
                   "Also write <name>_preview.png: colour, depth and labels side by side");
  app.add_option("--depth-camera", flags.depth_size,
                 "WIDTHxHEIGHT of a depth camera 25 mm to the left of colour, whose depth is "
                 "written as it is, not registered")
      ->excludes(preview);
  flags::NameMisspellings(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  WriteFrames(flags);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace fovea::scenes

int main(int argc, char** argv) {
  try {
    return fovea::scenes::Run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "fovea-scenes: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
