// The table behind access to options by name.
#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "core/options.h"

namespace fovea {

struct OptionEntry {
  OptionInfo info;
  // Where the value lives.
  std::function<std::variant<double*, int*, bool*>(DetectorOptions&)> locate;
};

// Every option with its range, in the order of the pipeline.
const std::vector<OptionEntry>& OptionTable();

}  // namespace fovea
