#include "client/capture/record_command.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "client/capture/camera_error.h"
#include "client/capture/openni_camera.h"
#include "client/capture/recording_file.h"
#include "client/capture/stop_signal.h"
#include "client/capture/v4l2_camera.h"

namespace fovea::capture {
namespace {

constexpr std::size_t kNumStreams = 2;

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
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error("cannot record to " + path + ": no folder " + folder.string());
  }
}

// Until the limits. OpenNI2 writes in a thread of its own, which begins a little later, so only
// what is in the file counts.
void Watch(OpenNiCamera& camera, const LimitFlags& limits, RecordingFile& file) {
  const auto end = EndOf(limits);
  const std::uint64_t max_frames = MaxFramesOf(limits);
  while (!StopAsked() && std::chrono::steady_clock::now() < end) {
    constexpr std::chrono::milliseconds kMoment{100};
    if (camera.Next(kMoment) && file.CountFrames(kNumStreams) >= max_frames) return;
  }
}

// OpenNI2 forgets what it has not written when it is stopped: returns once nothing more gets into
// the file.
void AwaitWritten(RecordingFile& file) {
  constexpr std::chrono::milliseconds kQuiet{300};
  std::uint64_t before = file.CountFrames(kNumStreams);
  while (true) {
    std::this_thread::sleep_for(kQuiet);
    const std::uint64_t now = file.CountFrames(kNumStreams);
    if (now == std::exchange(before, now)) return;
  }
}

// Beside the recording, so that a replay uses them, too.
void SaveIntrinsicsOf(const Camera& camera, const RecordFlags& flags) {
  const std::string path = IntrinsicsPathOf(flags.path);
  try {
    const ChosenIntrinsics chosen =
        ChooseIntrinsics(flags.intrinsics, camera.StatedFieldOfView(), camera.size());
    SaveIntrinsics(path, chosen.values, camera.size());
    std::cerr << "intrinsics: " << Describe(chosen) << ", in " << path << '\n';
  } catch (const NoIntrinsics& error) {
    std::cerr << "note: " << error.what() << "; no " << path << " is written\n";
  }
}

}  // namespace

int RunRecord(const RecordFlags& flags) {
  CheckPath(flags.path);
  if (IsRecording(flags.camera.device)) {
    throw std::invalid_argument("--device: a recording is recorded already");
  }
  if (IsV4l2(flags.camera.device)) {
    throw std::invalid_argument(
        "--device: only what OpenNI2 sees is recorded; fovea-capture --save keeps the frames of "
        "v4l2");
  }
  const OpenNiRuntime runtime;
  OpenNiCamera camera(CameraOptionsOf(flags.camera), std::cerr);
  SaveIntrinsicsOf(camera, flags);
  RecordingFile file(flags.path);
  std::exception_ptr error;
  {
    const Recording recording(flags.path, camera.BothStreams());
    std::cout << "recording " << camera.Uri() << " to " << flags.path << "; Ctrl-C ends it"
              << std::endl;
    try {
      Watch(camera, flags.limits, file);
    } catch (const CameraError&) {  // what was recorded until then stays
      error = std::current_exception();
    }
    camera.Stop();
    AwaitWritten(file);
  }
  const std::uint64_t num_frames = file.CountFrames(kNumStreams);
  std::cout << num_frames << " frames in " << flags.path << ", "
            << std::filesystem::file_size(flags.path) / 1000 << " kB" << std::endl;
  if (error) std::rethrow_exception(error);
  return num_frames > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace fovea::capture
