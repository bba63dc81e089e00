#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "client/cli/connection.h"
#include "client/cli/outputs.h"

namespace fovea::cli {

// The flags of `fovea detect` as they were written.
struct DetectFlags {
  ConnectionFlags connection;
  double timeout_s = 30;
  double time_budget_s = 0;  // 0: none
  std::string color, depth, intrinsics, depth_intrinsics, color_from_depth, gravity, profile, id,
      input, output;
  double depth_unit_m = 0.001;
  std::vector<std::string> settings;
  OutputPaths outputs;
};

void AddDetectFlags(CLI::App& command, DetectFlags& flags);

// What a person should read about a call of this command that failed.
std::string ExplainDetect(const client::RpcError& error, const DetectFlags& flags);

// Returns the exit code; throws std::exception with one line of text.
int RunDetect(const DetectFlags& flags);

}  // namespace fovea::cli
