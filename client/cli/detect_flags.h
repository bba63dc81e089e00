#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/cli/connection.h"
#include "client/cli/outputs.h"
#include "client/cli/question_flags.h"

namespace CLI {
class App;
}

namespace fovea::cli {

// The flags of `fovea detect` as they were written.
struct DetectFlags {
  ConnectionFlags connection;
  double timeout_s = 30;
  QuestionFlags question;
  std::string color, depth, intrinsics, depth_intrinsics, color_from_depth, distortion, gravity,
      camera_pose, id, input, output, color_topic, depth_topic;
  std::optional<double> depth_unit_m;  // none: a millimetre, or what a folder of such frames has
  std::vector<std::string> show;
  bool no_masks = false, no_overlay = false, resume = false;
  std::optional<int> jobs;  // none = as many as the server takes, up to 4
  Outputs outputs;          // of one frame
};

void AddDetectFlags(CLI::App& command, DetectFlags& flags);

// What --show names.
OverlayExtras ExtrasOf(const DetectFlags& flags);

}  // namespace fovea::cli
