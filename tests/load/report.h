#pragma once

#include <string>
#include <vector>

#include "tests/load/robot.h"

namespace fovea::load {

// What came of it over all robots: throughput, latency, drops, errors and fairness.
std::string Report(const std::vector<Outcome>& outcomes, double seconds);

}  // namespace fovea::load
