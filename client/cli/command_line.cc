#include "client/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/cli/busy_machine.h"
#include "client/cli/connection.h"
#include "client/cli/detect_command.h"
#include "client/cli/explain.h"
#include "client/cli/json.h"
#include "client/cli/options_command.h"
#include "client/cli/program.h"
#include "client/cli/server_address.h"
#include "client/client.h"
#include "flags/one_line.h"

namespace fovea::cli {
namespace {

void CheckHealth(const std::string& address, const client::Client& client) {
  if (!client.IsServing()) {
    throw std::runtime_error(address + " answers, but does not serve (it is stopping)");
  }
  std::cout << address << " is serving\n";
}

void PrintInfo(const std::string& address, const client::Client& client) {
  const v1::GetStatisticsResponse statistics = client.GetStatistics();
  using nlohmann::json;
  const std::string name = json(address).dump(-1, ' ', false, json::error_handler_t::replace);
  std::cout << "{\n\"address\": " << name << ",\n\"server\": " << ToJson(client.GetServerInfo())
            << ",\n\"statistics\": " << ToJson(statistics) << "}\n";
  std::cerr << NoteOfBusyMachine(statistics);
}

// A client of several servers would ask one of them, and tell nothing of the others. Whatever is
// wrong with one is said, and those after it are asked all the same.
int AskEach(const ConnectionFlags& flags,
            const std::function<void(const std::string&, const client::Client&)>& ask) {
  int code = EXIT_SUCCESS;
  ConnectionFlags one = flags;
  const std::vector<std::string> addresses = SplitServerAddresses(flags.server);
  const client::ClientOptions options = OptionsOf(flags);
  const auto complain = [&](const std::string& what) {
    std::cerr << "fovea: " << flags::OneLine(what) << '\n';
    code = EXIT_FAILURE;
  };
  for (const std::string& address : addresses) {
    one.server = address;
    try {
      ask(address, client::Client(address, options));
    } catch (const client::RpcError& error) {
      complain(Explain(error, one, DefaultLimit()));
    } catch (const std::runtime_error& error) {
      complain(error.what());
    }
  }
  return code;
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
  CLI::App* info = app.add_subcommand(
      "info",
      "Print the server's limits and statistics as JSON, of several servers a document each");
  CLI::App* options = app.add_subcommand("options", "Print the options of the server's method");
  for (CLI::App* command : {health, info, options}) AddConnectionFlags(*command, connection);

  return RunProgram(app, argc, argv, [&] {
    try {
      if (*health) return AskEach(connection, CheckHealth);
      if (*info) return AskEach(connection, PrintInfo);
      if (*options) {
        return AskEach(connection, [&](const std::string& address, const client::Client& client) {
          PrintOptions(address == connection.server ? "" : address + ":\n", client);
        });
      }
      if (*detect) return RunDetect(detect_flags);
      throw std::logic_error("this command does nothing");
    } catch (const client::RpcError& error) {
      throw std::runtime_error(ExplainDetect(error, detect_flags));
    }
  });
}

}  // namespace fovea::cli
