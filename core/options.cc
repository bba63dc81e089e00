#include "core/options.h"

#include <stdexcept>

namespace fovea {

DetectorOptions OptionsOfProfile(std::string_view) { return {}; }
std::vector<std::string> ProfileNames() { return {"default", "paper"}; }
std::vector<OptionInfo> ListOptions() { return {}; }
std::map<std::string, double> OptionValues(const DetectorOptions&) { return {}; }
void SetOption(DetectorOptions&, std::string_view name, double) {
  throw std::invalid_argument(std::string(name) + ": there is no such option");
}
void Validate(const DetectorOptions&) {}

}  // namespace fovea
