// fovea-capture: from an RGB-D camera to a fovea server.
#include <CLI/CLI.hpp>

#include "client/capture/camera_error.h"
#include "client/capture/devices_command.h"
#include "client/capture/flags.h"
#include "client/capture/record_command.h"
#include "client/capture/stop_signal.h"
#include "client/capture/stream_command.h"
#include "client/cli/program.h"

// What throws before RunProgram is a flag that is described wrongly, which ends each run.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  CLI::App app(
      "Streams an RGB-D camera (OpenNI2 or V4L2) to a fovea server and shows the objects that it "
      "finds.",
      "fovea-capture");
  app.set_version_flag("--version", "fovea-capture " FOVEA_VERSION);
  app.require_subcommand(0, 1);
  fovea::capture::StreamFlags live, replay;
  fovea::capture::RecordFlags record;
  fovea::capture::AddLiveFlags(app, live);
  CLI::App* record_command = app.add_subcommand("record", "Write what the camera sees to a file");
  fovea::capture::AddRecordFlags(*record_command, record);
  CLI::App* replay_command = app.add_subcommand("replay", "Detect in the frames of a recording");
  fovea::capture::AddReplayFlags(*replay_command, replay);
  CLI::App* devices_command =
      app.add_subcommand("devices", "List the cameras that are plugged in, and their modes");

  return fovea::cli::RunProgram(app, argc, argv, [&] {
    fovea::capture::RequireNoFlagsBeforeCommands(app);
    fovea::capture::CatchStopSignals();
    if (*devices_command) return fovea::capture::RunDevices();
    if (*record_command) return fovea::capture::RunRecord(record);
    if (*replay_command) fovea::capture::CheckRecording(replay.camera.device);
    return fovea::capture::RunStream(*replay_command ? replay : live);
  });
}
