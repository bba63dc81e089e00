// fovea: command-line client of a fovea server.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

#include "client/cli/busy_machine.h"
#include "client/cli/detect_command.h"
#include "client/cli/explain.h"
#include "client/cli/json.h"
#include "client/cli/options_command.h"
#include "client/cli/program.h"
#include "client/client.h"

namespace {

using fovea::cli::ConnectionFlags;

int CheckHealth(const ConnectionFlags& flags) {
  if (!fovea::cli::Connect(flags).IsServing()) {
    throw std::runtime_error(flags.server + " answers, but does not serve (it is stopping)");
  }
  std::cout << flags.server << " is serving\n";
  return EXIT_SUCCESS;
}

int PrintInfo(const ConnectionFlags& flags) {
  const fovea::client::Client client = fovea::cli::Connect(flags);
  const fovea::v1::GetStatisticsResponse statistics = client.GetStatistics();
  std::cout << "{\n\"server\": " << fovea::cli::ToJson(client.GetServerInfo())
            << ",\n\"statistics\": " << fovea::cli::ToJson(statistics) << "}\n";
  std::cerr << fovea::cli::NoteOfBusyMachine(statistics);
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Finds unknown objects in RGB-D frames by asking a fovea server.", "fovea");
  app.set_version_flag("--version", "fovea " FOVEA_VERSION);
  app.require_subcommand(1);

  fovea::cli::DetectFlags detect_flags;
  CLI::App* detect = app.add_subcommand("detect", "Detect the objects of one frame or a folder");
  fovea::cli::AddDetectFlags(*detect, detect_flags);

  ConnectionFlags connection;
  CLI::App* health = app.add_subcommand("health", "Ask whether the server serves");
  CLI::App* info = app.add_subcommand("info", "Print the server's limits and statistics as JSON");
  CLI::App* options = app.add_subcommand("options", "Print the options of the server's method");
  for (CLI::App* command : {health, info, options})
    fovea::cli::AddConnectionFlags(*command, connection);

  return fovea::cli::RunProgram(app, argc, argv, [&] {
    try {
      if (*health) return CheckHealth(connection);
      if (*info) return PrintInfo(connection);
      if (*options) return fovea::cli::PrintOptions(connection);
      return fovea::cli::RunDetect(detect_flags);
    } catch (const fovea::client::RpcError& error) {
      throw std::runtime_error(
          *detect ? fovea::cli::ExplainDetect(error, detect_flags)
                  : fovea::cli::Explain(error, connection, fovea::cli::DefaultLimit()));
    }
  });
}
