#include "tests/evaluation/settings.h"

#include <CLI/CLI.hpp>
#include <stdexcept>

namespace fovea::evaluation {

std::pair<std::string, std::vector<double>> ParseSetting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw std::invalid_argument(text + ": expected name=value");
  std::vector<double> values;
  for (const std::string& value : CLI::detail::split(text.substr(equals + 1), ',')) {
    values.push_back(std::stod(value));
  }
  return {text.substr(0, equals), values};
}

void ApplySettings(DetectorOptions& options, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const auto [name, values] = ParseSetting(setting);
    SetOption(options, name, values.at(0));
  }
}

}  // namespace fovea::evaluation
