#pragma once

#include <optional>
#include <string>

#include "client/cli/overlay/overlay.h"
#include "client/cli/request.h"

namespace fovea::cli {

// What to write of an answer, and where; empty = not wanted.
struct Outputs {
  std::string labels, json, overlay, cloud, height_map, saliency_prefix, steps;  // steps: a folder
  OverlayExtras extras;
  bool json_masks = true;
};

// Of `json`: standard output, a line an answer.
inline constexpr const char* kStandardOutput = "-";

// Asks for what these outputs need.
void RequestFor(const Outputs& outputs, v1::DetectOptions* options);

// The same without what only the JSON would tell.
void RequestForPictures(const Outputs& outputs, v1::DetectOptions* options);

// Writes all but a JSON line; NAME.json comes last. Throws std::exception
// with one line of text.
void WriteOutputs(const Outputs& outputs, const FrameFiles& files, const FrameSettings& settings,
                  const v1::DetectRequest& request, const v1::Detections& detections);

// The answer as one line, with its end.
std::string JsonLine(const Outputs& outputs, const v1::DetectRequest& request,
                     const v1::Detections& detections);

}  // namespace fovea::cli
