#include "client/capture/command_line.h"

#include <CLI/CLI.hpp>

#include "client/capture/camera_error.h"
#include "client/capture/devices_command.h"
#include "client/capture/flags.h"
#include "client/capture/record_command.h"
#include "client/capture/stop_signal.h"
#include "client/capture/stream_command.h"
#include "client/cli/program.h"

namespace fovea::capture {

int RunCommandLine(int argc, char** argv) {
  CLI::App app(
      "Streams an RGB-D camera (OpenNI2 or V4L2) to a fovea server and shows the objects that it "
      "finds.",
      "fovea-capture");
  app.set_version_flag("--version", "fovea-capture " FOVEA_VERSION);
  app.require_subcommand(0, 1);
  StreamFlags live, replay;
  RecordFlags record;
  AddLiveFlags(app, live);
  CLI::App* record_command = app.add_subcommand("record", "Write what the camera sees to a file");
  AddRecordFlags(*record_command, record);
  CLI::App* replay_command = app.add_subcommand("replay", "Detect in the frames of a recording");
  AddReplayFlags(*replay_command, replay);
  CLI::App* devices_command =
      app.add_subcommand("devices", "List the cameras that are plugged in, and their modes");

  return cli::RunProgram(app, argc, argv, [&] {
    RequireNoFlagsBeforeCommands(app);
    CatchStopSignals();
    if (*devices_command) return RunDevices();
    if (*record_command) return RunRecord(record);
    if (*replay_command) CheckRecording(replay.camera.device);
    return RunStream(*replay_command ? replay : live);
  });
}

}  // namespace fovea::capture
