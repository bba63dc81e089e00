#pragma once

#include <string>

#include "client/cli/request.h"

namespace fovea::cli {

// Where to write what; empty = not wanted.
struct OutputPaths {
  std::string labels, json, overlay, cloud, saliency_prefix, steps;  // steps: a folder
};

// The whole answer as the command line writes it.
std::string ToJson(const v1::Detections& detections);

// Asks for what these outputs need.
void RequestFor(const OutputPaths& paths, v1::DetectOptions* options);

// Writes them. Throws std::exception with one line of text.
void WriteOutputs(const OutputPaths& paths, const FrameFiles& files, const FrameSettings& settings,
                  const v1::DetectRequest& request, const v1::Detections& detections);

}  // namespace fovea::cli
