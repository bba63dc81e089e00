// The sensors by name, for command lines.
#pragma once

#include <map>
#include <string>

#include "tests/support/sensor.h"

namespace fovea::scenes {

const std::map<std::string, SensorKind>& SensorsByName();

}  // namespace fovea::scenes
