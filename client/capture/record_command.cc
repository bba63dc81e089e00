#include "client/capture/record_command.h"

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "client/capture/camera_error.h"
#include "client/capture/openni_camera.h"
#include "client/capture/recording.h"
#include "client/capture/recording_file.h"
#include "client/capture/stop_signal.h"

namespace fovea::capture {
namespace {

void CheckPath(const std::string& path) {
  if (!IsRecording(path)) throw std::invalid_argument(path + ": a recording's name ends in .oni");
  if (std::filesystem::exists(path)) throw std::runtime_error(path + " is there already");
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error("cannot record to " + path + ": no folder " + folder.string());
  }
}

// Intrinsics lie beside the recording, so that a replay uses them, too. A file of others there may
// be a calibration of somebody's, and would be taken for those of this recording.
void CheckIntrinsicsPath(const std::string& path, const KnownIntrinsics& known) {
  if (!std::filesystem::exists(path)) return;
  std::error_code error;  // where there is no calibration
  const bool is_given =
      known.camera && std::filesystem::equivalent(path, known.camera->path, error);
  if (is_given && known.distortion.empty()) return;
  throw std::runtime_error(path + " is there already and stays as it is; --calibration " + path +
                           ", without --distortion, records with it");
}

// None where the camera states none.
std::optional<ChosenIntrinsics> IntrinsicsOf(const Camera& camera, const KnownIntrinsics& known,
                                             const std::string& path) {
  try {
    ChosenIntrinsics chosen = ChooseIntrinsics(known, camera.StatedFieldOfView(), camera.size());
    std::cerr << "intrinsics: " << Describe(chosen) << ", in " << path << '\n';
    return chosen;
  } catch (const NoIntrinsics& error) {
    std::cerr << "note: " << error.what() << "; no " << path << " is written\n";
    return std::nullopt;
  }
}

struct Recorded {
  std::uint64_t num_frames = 0;
  std::exception_ptr error;  // of camera or disk, which may come after some frames
};

// OpenNI2 says nothing of a disk that is full, and goes on. Some frames are on their way to it.
std::uintmax_t RoomFor(const cv::Size& size) {
  constexpr std::uintmax_t kBytesPerPixel = 5, kFrames = 8;
  return kFrames * kBytesPerPixel * static_cast<std::uintmax_t>(size.area());
}

// Until the limits.
Recorded Record(OpenNiCamera& camera, const RecordFlags& flags) {
  const auto end = EndOf(flags.limits);
  const auto goes_on = [&] { return !StopAsked() && std::chrono::steady_clock::now() < end; };
  const std::uint64_t max_frames = MaxFramesOf(flags.limits);
  Recorded recorded;
  try {
    Recording recording(flags.path, camera);
    recording.Begin(goes_on, std::cerr);
    std::cout << "recording " << camera.Uri() << " to " << flags.path << "; Ctrl-C ends it"
              << std::endl;
    try {
      constexpr std::chrono::milliseconds kMoment{100};
      while (goes_on() && (!camera.Next(kMoment) || recording.NumWritten() < max_frames)) {
        RequireRoom(flags.path, RoomFor(camera.size()));
      }
    } catch (const std::exception&) {
      recorded.error = std::current_exception();
    }
    recorded.num_frames = recording.Finish();
  } catch (const std::exception&) {  // before it began
    recorded.error = std::current_exception();
  }
  return recorded;
}

// What went wrong before is what counts.
void SaveIntrinsicsOf(const ChosenIntrinsics& chosen, const cv::Size& size, const std::string& path,
                      std::exception_ptr* error) {
  try {
    SaveIntrinsics(path, chosen.values, size);
  } catch (const std::exception&) {
    if (!*error) *error = std::current_exception();
  }
}

// What was recorded until a camera fails or the disk is full stays.
void Keep(const Recorded& recorded, const std::string& path) {
  if (recorded.num_frames > 0) {
    std::cout << recorded.num_frames << " frames in " << path << ", "
              << std::filesystem::file_size(path) / 1000 << " kB" << std::endl;
  } else {
    std::filesystem::remove(path);  // it is none to OpenNI2
  }
  if (recorded.error) std::rethrow_exception(recorded.error);
  if (recorded.num_frames == 0) {
    throw std::runtime_error("nothing was recorded: it ended before a frame");
  }
}

}  // namespace

int RunRecord(const RecordFlags& flags) {
  CheckPath(flags.path);
  if (IsRecording(flags.camera.device)) {
    throw std::invalid_argument("--device: a recording is recorded already");
  }
  if (KindOf(flags.camera.device) != CameraKind::kOpenNi) {
    throw std::invalid_argument(
        "--device: only what OpenNI2 sees is recorded; fovea-capture --save keeps the frames of "
        "other cameras");
  }
  const CameraOptions options = CameraOptionsOf(flags.camera);
  const KnownIntrinsics intrinsics = ReadIntrinsics(flags.intrinsics);
  RequireSize(intrinsics, options.size);
  const std::string intrinsics_path = IntrinsicsPathOf(flags.path);
  CheckIntrinsicsPath(intrinsics_path, intrinsics);
  const OpenNiRuntime runtime;
  OpenNiCamera camera(options, std::cerr);
  const auto chosen = IntrinsicsOf(camera, intrinsics, intrinsics_path);
  Recorded recorded = Record(camera, flags);
  // Where they are there, they are the calibration, which stays as it is.
  if (chosen && recorded.num_frames > 0 && !std::filesystem::exists(intrinsics_path)) {
    SaveIntrinsicsOf(*chosen, camera.size(), intrinsics_path, &recorded.error);
  }
  Keep(recorded, flags.path);
  return EXIT_SUCCESS;
}

}  // namespace fovea::capture
