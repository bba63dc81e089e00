#include "core/options.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <variant>

#include "core/options_table.h"

namespace fovea {
namespace {

double Get(const OptionEntry& entry, const DetectorOptions& options) {
  // The table locates members of mutable options; reading does not change them.
  return std::visit([](const auto* value) { return static_cast<double>(*value); },
                    entry.locate(const_cast<DetectorOptions&>(options)));
}

void Check(const OptionInfo& info, double value) {
  const bool whole = !info.integral || value == std::floor(value);
  if (value >= info.minimum && value <= info.maximum && whole) return;
  std::ostringstream message;
  message << info.name << ": " << value << " is not " << (info.integral ? "a whole number " : "")
          << "in the range " << info.minimum << " to " << info.maximum;
  throw std::invalid_argument(message.str());
}

const OptionEntry& EntryOf(std::string_view name) {
  for (const OptionEntry& entry : OptionTable()) {
    if (entry.info.name == name) return entry;
  }
  throw std::invalid_argument(std::string(name) + ": there is no option of this name");
}

}  // namespace

std::vector<OptionInfo> ListOptions() {
  std::vector<OptionInfo> infos;
  for (const OptionEntry& entry : OptionTable()) infos.push_back(entry.info);
  return infos;
}

std::map<std::string, double> OptionValues(const DetectorOptions& options) {
  std::map<std::string, double> values;
  for (const OptionEntry& entry : OptionTable()) values[entry.info.name] = Get(entry, options);
  return values;
}

void SetOption(DetectorOptions& options, std::string_view name, double value) {
  const OptionEntry& entry = EntryOf(name);
  Check(entry.info, value);
  std::visit(
      [value](auto* member) {
        *member = static_cast<std::remove_reference_t<decltype(*member)>>(value);
      },
      entry.locate(options));
}

void Validate(const DetectorOptions& options) {
  for (const OptionEntry& entry : OptionTable()) Check(entry.info, Get(entry, options));
}

}  // namespace fovea
