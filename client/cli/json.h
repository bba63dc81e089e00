#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::cli {

enum class JsonLayout { kIndented, kOneLine };

// With the names of the contract. Throws std::runtime_error.
std::string ToJson(const google::protobuf::Message& message,
                   JsonLayout layout = JsonLayout::kIndented);

// An answer as NAME.json has it: the fields of Detections, and before them `frame`, what was sent
// of Frame beside the images (intrinsics, gravity, …).
std::string ToJson(const v1::Detections& detections, const v1::Frame& frame,
                   JsonLayout layout = JsonLayout::kIndented);

}  // namespace fovea::cli
