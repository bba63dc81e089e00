// Options of the detector as flags give them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/options.h"

namespace fovea::evaluation {

// name=value,value… → the name and the values. Throws std::invalid_argument.
std::pair<std::string, std::vector<double>> ParseSetting(const std::string& text);

// The same of values that `options` takes: what is wrong is to be known before hours of others.
std::pair<std::string, std::vector<double>> ParseSweep(const std::string& text,
                                                       const DetectorOptions& options);

// DIR or DIR=WEIGHT → the folder and its weight, 1 unless given. Throws std::invalid_argument.
std::pair<std::string, double> ParseWeighted(const std::string& text);

// Sets options by `settings`, each name=value. Throws std::invalid_argument like SetOption.
void ApplySettings(DetectorOptions& options, const std::vector<std::string>& settings);

}  // namespace fovea::evaluation
