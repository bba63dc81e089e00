#include "client/capture/record_command.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "client/capture/camera_error.h"
#include "client/capture/stop_signal.h"

namespace fovea::capture {
namespace {

// Writes from construction to destruction, which completes the file.
class Recording {
 public:
  Recording(const std::string& path, Streams& streams) {
    CheckWritable(path);
    Check(recorder_.create(path.c_str()), path);
    Check(recorder_.attach(streams.depth, /*allowLossyCompression=*/false), path);
    Check(recorder_.attach(streams.color, /*allowLossyCompression=*/false), path);
    Check(recorder_.start(), path);
  }
  ~Recording() {
    recorder_.stop();
    recorder_.destroy();
  }

  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

 private:
  // OpenNI2 itself crashes where it cannot make the file.
  static void CheckWritable(const std::string& path) {
    errno = 0;
    if (std::ofstream(path, std::ios::binary)) return;
    throw std::runtime_error("cannot record to " + path + ": " + std::strerror(errno));
  }

  static void Check(openni::Status status, const std::string& path) {
    if (status == openni::STATUS_OK) return;
    throw std::runtime_error("cannot record to " + path + ": " + OpenNiReason());
  }

  openni::Recorder recorder_;
};

void CheckPath(const std::string& path) {
  if (!IsRecording(path)) throw std::invalid_argument(path + ": a recording's name ends in .oni");
  if (std::filesystem::exists(path)) throw std::runtime_error(path + " is there already");
}

// Returns the number of pictures taken. Their images are written behind our back, by OpenNI2.
std::uint64_t Watch(Camera& camera, const LimitFlags& limits) {
  const auto end = EndOf(limits);
  const std::uint64_t max_frames = MaxFramesOf(limits);
  std::uint64_t num_pictures = 0;
  while (!StopAsked() && num_pictures < max_frames && std::chrono::steady_clock::now() < end) {
    constexpr std::chrono::milliseconds kMoment{100};
    if (camera.Next(kMoment)) ++num_pictures;
  }
  return num_pictures;
}

}  // namespace

int RunRecord(const RecordFlags& flags) {
  CheckPath(flags.path);
  if (IsRecording(flags.camera.device)) {
    throw std::invalid_argument("--device: a recording is recorded already");
  }
  const OpenNiRuntime runtime;
  Camera camera(CameraOptionsOf(flags.camera), std::cerr);
  std::uint64_t num_pictures = 0;
  {
    const Recording recording(flags.path, camera.streams());
    std::cout << "recording " << camera.uri() << " to " << flags.path << "; Ctrl-C ends it"
              << std::endl;
    num_pictures = Watch(camera, flags.limits);
  }
  std::cout << num_pictures << " frames in " << flags.path << ", "
            << std::filesystem::file_size(flags.path) / 1000 << " kB" << std::endl;
  return EXIT_SUCCESS;
}

}  // namespace fovea::capture
