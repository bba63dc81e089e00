#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/cli/connection.h"
#include "client/cli/outputs.h"

namespace CLI {
class App;
}

namespace fovea::cli {

// The flags of `fovea detect` as they were written.
struct DetectFlags {
  ConnectionFlags connection;
  double timeout_s = 30;
  double time_budget_s = 0;  // 0: none
  std::string color, depth, intrinsics, depth_intrinsics, color_from_depth, distortion, gravity,
      profile, id, input, output, place, color_topic, depth_topic;
  std::optional<double> depth_unit_m;  // none: a millimetre, or what a folder of such frames has
  std::vector<std::string> settings, grippers, show;
  bool no_masks = false, no_overlay = false, resume = false;
  int jobs = 4;
  Outputs outputs;  // of one frame
};

void AddDetectFlags(CLI::App& command, DetectFlags& flags);

// What --show names.
OverlayExtras ExtrasOf(const DetectFlags& flags);

}  // namespace fovea::cli
