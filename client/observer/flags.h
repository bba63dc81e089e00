// What fovea-observer is told on its command line.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/cli/connection.h"
#include "client/observer/history/history.h"

namespace CLI {
class App;
}

namespace fovea::observer {

struct Flags {
  cli::ConnectionFlags connection;
  std::string listen = "127.0.0.1:8080", https_cert, https_key;
  std::vector<std::string> hosts;
  bool insecure = false;
  std::string history, history_token_file;
  double history_minutes = 10, history_rate_hz = 2;
  std::uint64_t history_bytes = HistoryLimits().max_bytes;
};

// Fills `flags` when the command line is parsed; they must outlive it.
void AddFlags(CLI::App& app, Flags& flags);

}  // namespace fovea::observer
