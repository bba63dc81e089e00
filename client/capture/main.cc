// fovea-capture: from an RGB-D camera to a fovea server.
#include <grpc/support/log.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "client/capture/flags.h"
#include "client/capture/record_command.h"
#include "client/capture/stop_signal.h"
#include "client/capture/stream_command.h"

namespace {

int Run(int argc, char** argv) {
  CLI::App app(
      "Streams an RGB-D camera (OpenNI2) to a fovea server and shows the objects that it finds.",
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
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wants_text) {  // --help, --version
    return app.exit(wants_text);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(std::string(error.what()) + " (--help lists the flags)");
  }
  fovea::capture::CatchStopSignals();
  if (*record_command) return fovea::capture::RunRecord(record);
  return fovea::capture::RunStream(*replay_command ? replay : live);
}

}  // namespace

int main(int argc, char** argv) {
  // What matters of gRPC's own messages comes back as the status of the call.
  gpr_set_log_function([](gpr_log_func_args*) {});
  try {
    return Run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "fovea-capture: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
