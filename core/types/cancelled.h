// What ends a detection that its caller no longer wants.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/types/detections.h"

namespace fovea {

struct Cancelled : std::runtime_error {
  explicit Cancelled(std::string in_stage = "")
      : std::runtime_error("the detection was cancelled"), stage(std::move(in_stage)) {}

  std::string stage;                   // in which it was; empty where it had not begun
  std::vector<StageTime> stage_times;  // until then, of that stage included
};

}  // namespace fovea
