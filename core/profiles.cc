#include <stdexcept>

#include "core/options.h"

namespace fovea {
namespace {

// The initial values of the options' structs are the paper's.
DetectorOptions Paper() { return {}; }

DetectorOptions Default() {
  DetectorOptions options;
  return options;
}

}  // namespace

DetectorOptions OptionsOfProfile(std::string_view profile) {
  if (profile.empty() || profile == "default") return Default();
  if (profile == "paper") return Paper();
  throw std::invalid_argument("profile: \"" + std::string(profile) +
                              "\" is neither \"default\" nor \"paper\"");
}

std::vector<std::string> ProfileNames() { return {"default", "paper"}; }

}  // namespace fovea
