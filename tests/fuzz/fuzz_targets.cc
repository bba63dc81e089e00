#include "tests/fuzz/fuzz_targets.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fovea::fuzzing {

Target TargetOf(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Target>, 8> kTargets = {{
      {"bundle", FuzzBundle},
      {"jpeg", FuzzJpeg},
      {"mcap", FuzzMcap},
      {"png", FuzzPng},
      {"request", FuzzRequest},
      {"routes", FuzzRoutes},
      {"rvl", FuzzRvl},
      {"zstd", FuzzZstd},
  }};
  const auto found = std::ranges::find(kTargets, name, [](const auto& each) { return each.first; });
  return found == kTargets.end() ? nullptr : found->second;
}

}  // namespace fovea::fuzzing
