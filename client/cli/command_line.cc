#include "client/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "client/cli/busy_machine.h"
#include "client/cli/connection.h"
#include "client/cli/detect_command.h"
#include "client/cli/explain.h"
#include "client/cli/json.h"
#include "client/cli/options_command.h"
#include "client/cli/program.h"
#include "client/client.h"

namespace fovea::cli {
namespace {

int CheckHealth(const ConnectionFlags& flags) {
  if (!Connect(flags).IsServing()) {
    throw std::runtime_error(flags.server + " answers, but does not serve (it is stopping)");
  }
  std::cout << flags.server << " is serving\n";
  return EXIT_SUCCESS;
}

int PrintInfo(const ConnectionFlags& flags) {
  const client::Client client = Connect(flags);
  const v1::GetStatisticsResponse statistics = client.GetStatistics();
  std::cout << "{\n\"server\": " << ToJson(client.GetServerInfo())
            << ",\n\"statistics\": " << ToJson(statistics) << "}\n";
  std::cerr << NoteOfBusyMachine(statistics);
  return EXIT_SUCCESS;
}

}  // namespace

int RunCommandLine(int argc, char** argv, const std::string& version) {
  CLI::App app("Finds unknown objects in RGB-D frames by asking a fovea server.", "fovea");
  app.set_version_flag("--version", "fovea " + version);
  app.require_subcommand(1);

  DetectFlags detect_flags;
  CLI::App* detect = app.add_subcommand("detect", "Detect the objects of one frame or a folder");
  AddDetectFlags(*detect, detect_flags);

  ConnectionFlags connection;
  CLI::App* health = app.add_subcommand("health", "Ask whether the server serves");
  CLI::App* info = app.add_subcommand("info", "Print the server's limits and statistics as JSON");
  CLI::App* options = app.add_subcommand("options", "Print the options of the server's method");
  for (CLI::App* command : {health, info, options}) AddConnectionFlags(*command, connection);

  return RunProgram(app, argc, argv, [&] {
    try {
      if (*health) return CheckHealth(connection);
      if (*info) return PrintInfo(connection);
      if (*options) return PrintOptions(connection);
      return RunDetect(detect_flags);
    } catch (const client::RpcError& error) {
      throw std::runtime_error(*detect ? ExplainDetect(error, detect_flags)
                                       : Explain(error, connection, DefaultLimit()));
    }
  });
}

}  // namespace fovea::cli
