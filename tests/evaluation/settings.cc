#include "tests/evaluation/settings.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <stdexcept>

namespace fovea::evaluation {
namespace {

// Of `text`, which stands in `whole`.
double NumberOf(const std::string& text, const std::string& whole) {
  double number = 0;
  if (!CLI::detail::lexical_cast(text, number) || !std::isfinite(number)) {
    throw std::invalid_argument(whole + ": \"" + text + "\" is no number");
  }
  return number;
}

}  // namespace

std::pair<std::string, std::vector<double>> ParseSetting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw std::invalid_argument(text + ": expected name=value");
  std::vector<double> values;
  for (const std::string& value : CLI::detail::split(text.substr(equals + 1), ',')) {
    values.push_back(NumberOf(value, text));
  }
  return {text.substr(0, equals), values};
}

std::pair<std::string, std::vector<double>> ParseSweep(const std::string& text,
                                                       const DetectorOptions& options) {
  auto sweep = ParseSetting(text);
  DetectorOptions changed = options;
  for (const double value : sweep.second) SetOption(changed, sweep.first, value);
  return sweep;
}

std::pair<std::string, double> ParseWeighted(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return {text, 1};
  const double weight = NumberOf(text.substr(equals + 1), text);
  if (weight <= 0) throw std::invalid_argument(text + ": weights are positive");
  return {text.substr(0, equals), weight};
}

void ApplySettings(DetectorOptions& options, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const auto [name, values] = ParseSetting(setting);
    if (values.size() != 1) throw std::invalid_argument(setting + ": expected one value");
    SetOption(options, name, values.front());
  }
}

}  // namespace fovea::evaluation
