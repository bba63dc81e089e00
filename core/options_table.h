// The table behind access to options by name.
#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "core/options.h"

namespace fovea {

// Where the value of an option lives; std::monostate: the profile does not read it.
using OptionValue = std::variant<std::monostate, double*, int*, bool*>;

struct OptionEntry {
  OptionInfo info;
  std::function<OptionValue(DetectorOptions&)> locate;
};

// Every option with its range, in the order of the pipeline.
const std::vector<OptionEntry>& OptionTable();

}  // namespace fovea
