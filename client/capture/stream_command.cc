#include "client/capture/stream_command.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "client/capture/camera_error.h"
#include "client/capture/crash_watch.h"
#include "client/capture/devices.h"
#include "client/capture/save_folder.h"
#include "client/capture/server_check.h"
#include "client/cli/explain.h"

namespace fovea::capture {
namespace {

using std::chrono::steady_clock;

// A recording is played frame by frame, unless a speed is given.
bool TakesEveryFrame(const StreamFlags& flags) {
  return flags.every_frame || (IsRecording(flags.camera.device) && flags.speed == 0);
}

void RequireStream(const StreamFlags& flags) {
  if (!flags.track || !TakesEveryFrame(flags)) return;
  throw std::invalid_argument(
      "--track: only frames that are streamed are tracked; leave --every-frame out, and give "
      "recordings a --speed");
}

client::Client ConnectTo(const StreamFlags& flags) {
  client::ClientOptions options;
  client::Client client = cli::Connect(flags.connection, options);
  if (!flags.any_version) std::cerr << CheckServer(client, flags.connection) << '\n';
  // A stream that broke is taken up again for as long.
  options.timeout = std::chrono::milliseconds(static_cast<int>(flags.patience_s * 1000) + 1);
  return cli::Connect(flags.connection, options);
}

// A recording's own lie beside it.
IntrinsicsFlags FlagsOrBeside(const StreamFlags& flags) {
  const bool given =
      !flags.intrinsics.calibration_path.empty() || !flags.intrinsics.numbers_or_file.empty();
  if (given || !IsRecording(flags.camera.device)) return flags.intrinsics;
  const std::string path = IntrinsicsPathOf(flags.camera.device);
  return {std::filesystem::exists(path) ? path : "", "", flags.intrinsics.distortion};
}

// Recordings alone have a size of their own.
KnownIntrinsics IntrinsicsFor(const StreamFlags& flags, const CameraOptions& camera) {
  KnownIntrinsics known = ReadIntrinsics(FlagsOrBeside(flags));
  if (!IsRecording(camera.device)) RequireSize(known, camera.size);
  return known;
}

ChosenIntrinsics Choose(const KnownIntrinsics& known, const Camera& camera) {
  ChosenIntrinsics chosen = ChooseIntrinsics(known, camera.StatedFieldOfView(), camera.size());
  std::cerr << "intrinsics: " << Describe(chosen) << '\n';
  if (!chosen.warning.empty()) std::cerr << "note: " << chosen.warning << '\n';
  return chosen;
}

void Run(const StreamFlags& flags, const SessionOptions& options, const Session& session) {
  try {
    TakesEveryFrame(flags) ? RunEveryFrame(options, session) : RunLive(options, session);
  } catch (const client::RpcError& error) {
    throw std::runtime_error(cli::Explain(error, flags.connection, "its deadline"));
  }
}

void PrintSummary(const Session& session, steady_clock::time_point start) {
  session.tally.Finish();
  const std::chrono::duration<double> took = steady_clock::now() - start;
  if (session.source.AtEnd()) std::cout << "end of the recording\n";
  std::cout << Summary(session.tally, session.source.NumPictures(), session.source.Losses(),
                       session.source.NumReopened())
            << CpuUse(took.count()) << std::flush;
}

}  // namespace

int RunStream(const StreamFlags& flags) {
  const steady_clock::time_point start = steady_clock::now();
  RequireStream(flags);
  SessionOptions options = SessionOptionsOf(flags);
  CameraOptions camera_options = CameraOptionsOf(flags.camera);
  if (IsRecording(camera_options.device)) {
    CheckRecording(camera_options.device);
    GoOnWatched(camera_options.device);
  }
  const KnownIntrinsics intrinsics = IntrinsicsFor(flags, camera_options);
  PrepareSaveFolder(flags.save_folder);
  if (flags.speed > 0) camera_options.speed = flags.speed;
  std::optional<Viewer> viewer;
  if (flags.view) viewer.emplace();
  const client::Client client = ConnectTo(flags);
  std::optional<OpenNiRuntime> openni;
  if (KindOf(camera_options.device) == CameraKind::kOpenNi) openni.emplace();
  CameraSource source(camera_options, options.patience, std::cerr);
  options.intrinsics = Choose(intrinsics, source.CurrentCamera()).values;
  Viewer* const window = viewer ? &*viewer : nullptr;
  v1::Frame cameras;
  SetCameras(options, &cameras);
  Results results(flags.save_folder, cameras, window, std::cout);
  Tally tally;
  const Session session{client, source, results, window, tally, std::cerr};
  std::exception_ptr error;
  try {
    Run(flags, options, session);
  } catch (const std::exception&) {
    error = std::current_exception();
  }
  PrintSummary(session, start);
  if (error) std::rethrow_exception(error);
  if (source.AtEnd() && source.NumPictures() == 0) {
    throw std::runtime_error(camera_options.device +
                             " has no frame that can be played: it was never ended, as where "
                             "fovea-capture record is killed");
  }
  return tally.Snapshot().failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace fovea::capture
