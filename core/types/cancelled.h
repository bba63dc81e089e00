// What ends a detection that its caller no longer wants.
#pragma once

#include <stdexcept>

namespace fovea {

struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("the detection was cancelled") {}
};

}  // namespace fovea
